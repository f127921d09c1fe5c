#include "ChildProcess.h"

#include "SharedMemory.h"
#include "VolumeReadingError.h"

#include <cerrno>
#include <cstring>
#include <utility>

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

extern char** environ;

namespace penumbra
{

namespace
{

#ifdef MSG_NOSIGNAL
constexpr int SendFlags = MSG_NOSIGNAL;
#else
constexpr int SendFlags = 0;
#endif

// A child that does not read what it is asked for hangs.
constexpr timeval LongestSend = { 10, 0 };

[[noreturn]] void ThrowNotStarted(const std::string& program, int error)
{
  throw VolumeReadingError(
    "the program " + program + " that parses it cannot be started: " + std::strerror(error));
}

// The two ends of a connection, of which other programs that are started meanwhile get none. They
// are closed with it unless taken.
class SocketPair
{
public:
  explicit SocketPair(const std::string& program)
    : SocketPair() // so that what is thrown here closes them
  {
    if (socketpair(AF_UNIX, SOCK_STREAM, 0, this->Ends) != 0)
    {
      ThrowNotStarted(program, errno);
    }
    for (int& end : this->Ends)
    {
      // Away from the standard ones, which may be free.
      const int moved = fcntl(end, F_DUPFD_CLOEXEC, SharedMemory::HandleForChild + 1);
      const int error = errno;
      close(std::exchange(end, moved));
      if (moved < 0)
      {
        ThrowNotStarted(program, error);
      }
    }
    setsockopt(this->Ends[0], SOL_SOCKET, SO_SNDTIMEO, &LongestSend, sizeof(LongestSend));
#ifdef SO_NOSIGPIPE
    const int yes = 1;
    setsockopt(this->Ends[0], SOL_SOCKET, SO_NOSIGPIPE, &yes, sizeof(yes));
#endif
  }

  ~SocketPair()
  {
    for (const int end : this->Ends)
    {
      close(end);
    }
  }
  SocketPair(const SocketPair&) = delete;
  SocketPair& operator=(const SocketPair&) = delete;

  int GetChildEnd() const
  {
    return this->Ends[1];
  }
  int TakeOwnEnd()
  {
    return std::exchange(this->Ends[0], -1);
  }

private:
  SocketPair() = default;

  int Ends[2] = { -1, -1 };
};

// What the child's first file descriptors are.
class FileActions
{
public:
  FileActions(int connection, int memory)
  {
    posix_spawn_file_actions_init(&this->Actions);
    posix_spawn_file_actions_adddup2(&this->Actions, connection, STDIN_FILENO);
    posix_spawn_file_actions_adddup2(&this->Actions, connection, STDOUT_FILENO);
    posix_spawn_file_actions_addopen(&this->Actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
    posix_spawn_file_actions_adddup2(&this->Actions, memory, SharedMemory::HandleForChild);
  }

  ~FileActions() { posix_spawn_file_actions_destroy(&this->Actions); }
  FileActions(const FileActions&) = delete;
  FileActions& operator=(const FileActions&) = delete;

  const posix_spawn_file_actions_t* Get() const { return &this->Actions; }

private:
  posix_spawn_file_actions_t Actions;
};

}

ChildProcess::ChildProcess(const std::vector<std::string>& command, const SharedMemory& memory)
{
  SocketPair connection(command.front());
  const FileActions actions(connection.GetChildEnd(), memory.GetHandle());
  std::vector<char*> arguments;
  for (const std::string& argument : command)
  {
    arguments.push_back(const_cast<char*>(argument.c_str()));
  }
  arguments.push_back(nullptr);
  pid_t process = -1;
  const int error =
    posix_spawn(&process, arguments.front(), actions.Get(), nullptr, arguments.data(), environ);
  if (error != 0)
  {
    ThrowNotStarted(command.front(), error);
  }
  this->Connection = connection.TakeOwnEnd();
  this->Process = process;
}

ChildProcess::~ChildProcess()
{
  close(this->Connection);
  kill(this->Process, SIGKILL);
  while (waitpid(this->Process, nullptr, 0) < 0 && errno == EINTR)
  {
  }
}

bool ChildProcess::Send(const std::string& bytes)
{
  std::size_t sent = 0;
  while (sent < bytes.size())
  {
    const ssize_t count =
      send(this->Connection, bytes.data() + sent, bytes.size() - sent, SendFlags);
    if (count < 0 && errno != EINTR)
    {
      return false;
    }
    sent += count > 0 ? static_cast<std::size_t>(count) : 0;
  }
  return true;
}

ChildProcess::Output ChildProcess::Wait(double seconds, std::string& bytes)
{
  pollfd state = { this->Connection, POLLIN, 0 };
  constexpr double millisecondsPerSecond = 1000.0;
  const int ready = poll(&state, 1, static_cast<int>(seconds * millisecondsPerSecond));
  if (ready == 0 || (ready < 0 && errno == EINTR))
  {
    return Output::NoneYet;
  }
  char part[65536];
  const ssize_t count = recv(this->Connection, part, sizeof(part), 0);
  if (count <= 0)
  {
    return count < 0 && errno == EINTR ? Output::NoneYet : Output::Ended;
  }
  bytes.append(part, static_cast<std::size_t>(count));
  return Output::Some;
}

}
