#include "DicomConversation.h"

#include <algorithm>
#include <filesystem>
#include <utility>

using nlohmann::json;

namespace penumbra
{

namespace
{

constexpr double BytesPerMiB = 1048576.0;

// How often the user is asked whether to go on while nothing else happens.
constexpr double SecondsBetweenLooks = 0.1;

}

DicomConversation::DicomConversation(const DicomRequest& request, double secondsPerFile)
  : Request(request)
  , SecondsPerFile(secondsPerFile)
{
}

ConversationEnd DicomConversation::Hold(
  std::unique_ptr<ChildProcess>& child, const Answer& answer, const ReadingProgress& progress)
{
  std::unique_ptr<ChildProcess> process = std::move(child);
  const ConversationEnd end = this->Hold(*process, answer, progress);
  if (end == ConversationEnd::Done)
  {
    child = std::move(process);
  }
  return end;
}

ConversationEnd DicomConversation::Hold(
  ChildProcess& process, const Answer& answer, const ReadingProgress& progress)
{
  if (!process.Send(Encode(ToMessage(this->Request))))
  {
    return ConversationEnd::Crashed;
  }
  this->Begin(std::nullopt);
  std::string bytes;
  while (true)
  {
    const ChildProcess::Output output = process.Wait(SecondsBetweenLooks, bytes);
    if (!this->TakeAnswers(bytes, answer))
    {
      return ConversationEnd::Crashed;
    }
    if (!progress(this->Progress))
    {
      throw ReadingCancelled();
    }
    if (this->IsDone || output == ChildProcess::Output::Ended)
    {
      return this->IsDone ? ConversationEnd::Done : ConversationEnd::Crashed;
    }
    if (Clock::now() > this->Deadline)
    {
      return ConversationEnd::TooLong;
    }
  }
}

bool DicomConversation::TakeAnswers(std::string& bytes, const Answer& answer)
{
  try
  {
    while (const auto message = TakeMessage(bytes))
    {
      if (message->contains(DicomAnswer::Start))
      {
        this->Begin(message->at(DicomAnswer::Start).get<std::size_t>());
        // Slices decoded in parallel may tell their start out of order.
        this->Progress = std::max(this->Progress, message->at(DicomAnswer::Progress).get<double>());
      }
      else if (message->contains(DicomAnswer::Done))
      {
        this->IsDone = true;
      }
      else
      {
        answer(*message);
      }
    }
    return true;
  }
  catch (const json::exception&)
  {
    return false;
  }
}

void DicomConversation::Begin(std::optional<std::size_t> file)
{
  this->Started = file;
  double bytes = 0.0;
  if (file && *file < this->Request.files.size())
  {
    std::error_code ignored;
    const auto size = std::filesystem::file_size(this->Request.files[*file].path, ignored);
    bytes = ignored ? 0.0 : static_cast<double>(size);
  }
  const std::chrono::duration<double> allowed(this->SecondsPerFile + bytes / BytesPerMiB);
  this->Deadline = Clock::now() + std::chrono::duration_cast<Clock::duration>(allowed);
}

}
