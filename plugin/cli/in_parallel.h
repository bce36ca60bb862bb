// Independent cases on several threads.
#pragma once

#include <functional>

namespace softsoil {

// Calls work(0) to work(count - 1), each once, on at most `threads` >= 1 threads. After an
// exception no further case begins; the exception of the first case that threw is thrown again
// when all threads are done.
void InParallel(int count, int threads, const std::function<void(int)>& work);

}  // namespace softsoil
