#pragma once
// How Program steps the lanes of a Sum or Solve. Internal to libbrdf/formula. begin... prepares the state before the
// body runs for the first time; continue... looks at what the body gave and says whether it must run again. A lane that
// has ended keeps its result whatever its neighbours do.
#include <brdf/formula/Kernels.h>

#include <cmath>
#include <limits>

namespace brdf::formula {

template <class T>
struct LoopOperand {
  const T* data;
  std::size_t stride;  ///< 0: one number for all lanes
  T operator[](std::size_t i) const { return data[i * stride]; }
};

template <class T>
struct LoopFrame {
  LoopOperand<T> from, to, body, slope;
  T* bound;
  T* result;
  T* state[4];
  double tolerance;
};

// Sum. state[0]: 1 while the lane runs; state[1]: the size of its last term; state[2]: small terms running.

template <class T>
bool beginSum(const LoopFrame<T>& f) {
  for (std::size_t i = 0; i < kLanes<T>; ++i) {
    f.bound[i] = f.from[i];
    f.result[i] = 0;
    f.state[0][i] = f.from[i] <= f.to[i] ? T(1) : T(0);
    f.state[1][i] = 0;
    f.state[2][i] = 0;
  }
  return true;
}

template <class T>
bool continueSum(const LoopFrame<T>& f, int round) {
  bool any = false;
  const T tolerance = static_cast<T>(f.tolerance);
  for (std::size_t i = 0; i < kLanes<T>; ++i) {
    if (f.state[0][i] == 0) continue;
    const T term = f.body[i], size = std::fabs(term);
    f.result[i] += term;
    f.state[2][i] = size < f.state[1][i] && size <= tolerance * std::fabs(f.result[i]) ? f.state[2][i] + 1 : T(0);
    f.state[1][i] = size;
    f.bound[i] += 1;
    const bool runs = f.bound[i] <= f.to[i] && f.state[2][i] < 2;
    f.state[0][i] = runs ? T(1) : T(0);
    any = any || runs;
  }
  return any && round < kMaximumTerms;
}

// Solve. state[0]: 1 while the lane runs; state[1], state[2]: the bracket; state[3]: f at the bracket's first end.

template <class T>
bool beginSolve(const LoopFrame<T>& f) {
  for (std::size_t i = 0; i < kLanes<T>; ++i) {
    f.state[0][i] = 1;
    f.state[1][i] = f.from[i];
    f.state[2][i] = f.to[i];
    f.bound[i] = f.from[i];
    f.result[i] = f.from[i];
  }
  return true;
}

template <class T>
bool continueSolve(const LoopFrame<T>& f, int round) {
  bool any = false;
  for (std::size_t i = 0; i < kLanes<T>; ++i) {
    if (f.state[0][i] == 0) continue;
    const T value = f.body[i];
    T& low = f.state[1][i];
    T& high = f.state[2][i];
    if (round == 1) {
      f.state[3][i] = value;
      f.bound[i] = high;
    } else if (round == 2 && (value > 0) == (f.state[3][i] > 0) && value != 0) {
      f.result[i] = std::fabs(value) < std::fabs(f.state[3][i]) ? high : low;
      f.state[0][i] = 0;
      continue;
    } else {
      const T x = f.bound[i];
      T next = low + (high - low) / 2;
      if (round > 2) {
        ((value > 0) == (f.state[3][i] > 0) ? low : high) = x;
        const T newton = x - value / f.slope[i];
        next = low + (high - low) / 2;
        if (newton > std::fmin(low, high) && newton < std::fmax(low, high)) next = newton;
      }
      const bool ended =
          round > 2 && (value == 0 || std::fabs(next - x) <= std::numeric_limits<T>::epsilon() * std::fabs(x));
      f.result[i] = value == 0 ? x : next;
      f.bound[i] = f.result[i];
      if (ended || value == 0) {
        f.state[0][i] = 0;
        continue;
      }
    }
    any = true;
  }
  return any && round < kMaximumIterations;
}

}  // namespace brdf::formula
