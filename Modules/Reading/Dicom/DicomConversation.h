/**
 * @class   DicomConversation
 * @brief   one request to a parser process and its answers, within a time for each file
 */

#ifndef DicomConversation_h
#define DicomConversation_h

#include "ChildProcess.h"
#include "DicomMessages.h"

#include <chrono>
#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>

namespace penumbra
{

/**
 * How asking a parser process for something ends.
 */
enum class ConversationEnd
{
  Done,
  Crashed,
  TooLong
};

class DicomConversation
{
public:
  using Answer = std::function<void(const nlohmann::json&)>;

  /// `request` is to live as long as this object. A file may take the seconds, and one more for
  /// each MiB of it.
  DicomConversation(const DicomRequest& request, double secondsPerFile);

  /**
   * Hands each of the answers to `answer`. A process with which the conversation is broken off does
   * not survive it, and `child` is then null. Throws ReadingCancelled where `progress` says so.
   */
  ConversationEnd Hold(
    std::unique_ptr<ChildProcess>& child, const Answer& answer, const ReadingProgress& progress);

  /// The file that was being parsed at the end, if any was.
  std::optional<std::size_t> GetStarted() const { return this->Started; }

private:
  using Clock = std::chrono::steady_clock;

  ConversationEnd Hold(
    ChildProcess& process, const Answer& answer, const ReadingProgress& progress);
  // Returns whether all of it makes sense.
  bool TakeAnswers(std::string& bytes, const Answer& answer);
  void Begin(std::optional<std::size_t> file);

  const DicomRequest& Request;
  double SecondsPerFile;
  std::optional<std::size_t> Started;
  double Progress = 0.0;
  bool IsDone = false;
  Clock::time_point Deadline;
};

}

#endif
