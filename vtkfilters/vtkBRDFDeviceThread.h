#ifndef vtkBRDFDeviceThread_h
#define vtkBRDFDeviceThread_h
// A thread that owns an OpenGL context. For .cxx files only.

#include <condition_variable>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <utility>

// Contexts are current in a thread: one that has a thread of its own is never in the way of a window's, whatever made
// that one current (GLX, EGL, Qt) and whichever threads take turns in calling.
class vtkBRDFDeviceThread
{
public:
  vtkBRDFDeviceThread()
    : Worker([this] { this->Work(); })
  {
  }
  ~vtkBRDFDeviceThread()
  {
    {
      const std::lock_guard lock(this->Mutex);
      this->Ends = true;
    }
    this->Changed.notify_all();
    this->Worker.join();
  }
  vtkBRDFDeviceThread(const vtkBRDFDeviceThread&) = delete;
  void operator=(const vtkBRDFDeviceThread&) = delete;

  // Calls `task` on the thread and waits; what it throws is thrown here. One caller at a time.
  void Run(const std::function<void()>& task)
  {
    std::unique_lock lock(this->Mutex);
    this->Task = &task;
    this->Changed.notify_all();
    this->Changed.wait(lock, [this] { return this->Task == nullptr; });
    if (this->Thrown)
    {
      std::rethrow_exception(std::exchange(this->Thrown, nullptr));
    }
  }

private:
  void Work()
  {
    std::unique_lock lock(this->Mutex);
    for (;;)
    {
      this->Changed.wait(lock, [this] { return this->Ends || this->Task; });
      if (this->Ends)
      {
        return;
      }
      try
      {
        (*this->Task)();
      }
      catch (...)
      {
        this->Thrown = std::current_exception();
      }
      this->Task = nullptr;
      this->Changed.notify_all();
    }
  }

  std::mutex Mutex;
  std::condition_variable Changed;
  const std::function<void()>* Task = nullptr;
  std::exception_ptr Thrown;
  bool Ends = false;
  std::thread Worker; // last: it uses the others
};

#endif
