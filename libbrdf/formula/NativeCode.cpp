#include <brdf/formula/NativeCode.h>

#include <bit>

#if defined(__x86_64__)
#include <brdf/formula/NativeEmitter.h>
#endif

namespace brdf::formula {

template <class T>
void writeNativeConstants(T* behindUniforms) {
  using Bits = std::conditional_t<sizeof(T) == 4, std::uint32_t, std::uint64_t>;
  constexpr Bits sign = Bits{1} << (8 * sizeof(T) - 1);
  behindUniforms[0] = 1;
  behindUniforms[1] = T(0.5);
  behindUniforms[2] = T(0.375);
  behindUniforms[3] = std::bit_cast<T>(sign);
  behindUniforms[4] = std::bit_cast<T>(~sign);
}
template void writeNativeConstants(float*);
template void writeNativeConstants(double*);

#if defined(__x86_64__)

template <class T>
struct NativeCode<T>::Code {
  std::unique_ptr<NativeEmitter> emitter, streamingEmitter;  // own the memory of the code
  NativeEmitter::Function<T> function, streaming;
  std::size_t width;
};

template <class T>
std::unique_ptr<const NativeCode<T>> NativeCode<T>::make(const Program& program, const KernelSet& set) {
  if (set.vectorBytes == 0 || !program.straight()) return nullptr;
  try {
    auto code = std::make_unique<Code>();
    code->emitter = std::make_unique<NativeEmitter>(program, set, sizeof(T), false);
    code->function = code->emitter->template finish<T>();
    code->streamingEmitter = std::make_unique<NativeEmitter>(program, set, sizeof(T), true);
    code->streaming = code->streamingEmitter->template finish<T>();
    code->width = set.vectorBytes / sizeof(T);
    return std::unique_ptr<const NativeCode>(new NativeCode(std::move(code)));
  } catch (const Xbyak::Error&) {
    return nullptr;  // no executable memory: the kernels serve
  }
}

template <class T>
std::size_t NativeCode<T>::width() const {
  return code_->width;
}

template <class T>
void NativeCode<T>::run(const T* const* inputs, T* const* outputs, const T* uniforms, std::size_t count) const {
  code_->function(inputs, outputs, uniforms, count * sizeof(T));
}

template <class T>
void NativeCode<T>::runStreaming(const T* const* inputs, T* const* outputs, const T* uniforms,
                                 std::size_t count) const {
  code_->streaming(inputs, outputs, uniforms, count * sizeof(T));
}

#else

template <class T>
struct NativeCode<T>::Code {};

template <class T>
std::unique_ptr<const NativeCode<T>> NativeCode<T>::make(const Program&, const KernelSet&) {
  return nullptr;
}

template <class T>
std::size_t NativeCode<T>::width() const {
  return 1;
}

template <class T>
void NativeCode<T>::run(const T* const*, T* const*, const T*, std::size_t) const {}
template <class T>
void NativeCode<T>::runStreaming(const T* const*, T* const*, const T*, std::size_t) const {}

#endif

template <class T>
NativeCode<T>::NativeCode(std::unique_ptr<Code> code) : code_(std::move(code)) {}
template <class T>
NativeCode<T>::~NativeCode() = default;

template class NativeCode<float>;
template class NativeCode<double>;

}  // namespace brdf::formula
