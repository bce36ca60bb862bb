// Independent cases on several threads.
#pragma once

#include <functional>

namespace softsoil {

// Calls work(0) to work(count - 1), each once, on at most `threads` >= 1 threads. After an
// exception no further case is taken up; when all threads are done the exception of the lowest case
// is thrown again, which is the same on any number of threads.
void InParallel(int count, int threads, const std::function<void(int)>& work);

}  // namespace softsoil
