#include "DicomParserProcess.h"

#include "DicomMessages.h"
#include "SharedArray.h"
#include "vtkDataArray.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <iterator>
#include <utility>

using nlohmann::json;

namespace penumbra
{

namespace
{

namespace fs = std::filesystem;

// For the program itself and what libraries keep.
constexpr std::uint64_t ProgramMemory = std::uint64_t(1) << 30;

// The address space of a thread: its stack, and what the C library sets aside for it.
constexpr std::uint64_t ThreadMemory = std::uint64_t(1) << 28;

// Parsing keeps the file's bytes, and copies of parts of them.
constexpr std::uint64_t MemoryPerFileByte = 4;

std::string ReasonOf(ConversationEnd end)
{
  return end == ConversationEnd::TooLong ? "the DICOM library does not come to an end with it"
                                         : "the DICOM library fails on it; it is damaged";
}

std::uint64_t LargestFile(const std::vector<DicomFile>& files)
{
  std::uint64_t largest = 0;
  for (const DicomFile& file : files)
  {
    std::error_code ignored;
    const auto size = fs::file_size(file.path, ignored);
    largest = ignored ? largest : std::max<std::uint64_t>(largest, size);
  }
  return largest;
}

std::uint64_t LargestDecoded(const std::vector<DicomFile>& files)
{
  std::uint64_t largest = 0;
  for (const DicomFile& file : files)
  {
    const DicomImage& image = file.image;
    largest = std::max(largest,
      static_cast<std::uint64_t>(image.columns) * static_cast<std::uint64_t>(image.rows) *
        image.frames.size() * static_cast<std::uint64_t>(image.pixel.bitsAllocated / 8));
  }
  return largest;
}

std::uint64_t MemoryForHeaders(const DicomRequest& request, const DicomParserLimits& limits)
{
  return ProgramMemory + std::min(limits.memory, MemoryPerFileByte * LargestFile(request.files));
}

std::uint64_t MemoryForVoxels(const DicomRequest& request, const DicomParserLimits& limits)
{
  constexpr std::uint64_t widestScalar = 8;
  const std::uint64_t voxels = widestScalar * NumberOfVoxels(request.plan.geometry, widestScalar);
  const auto threads =
    request.inParallel ? static_cast<std::uint64_t>(vtkSMPTools::GetEstimatedNumberOfThreads()) : 1;
  const std::uint64_t file = LargestFile(request.files) + LargestDecoded(request.files);
  return ProgramMemory + threads * ThreadMemory +
    std::min(limits.memory, voxels + threads * MemoryPerFileByte * file);
}

// A parser that a file has broken may say anything.
DicomHeaderResult ResultFromMessage(const json& message)
{
  if (!message.contains(DicomAnswer::Image))
  {
    return message.at(DicomAnswer::Failure).get<std::string>();
  }
  DicomImage image = ImageFromMessage(message.at(DicomAnswer::Image));
  const bool isPossible = image.columns > 0 && image.rows > 0 && !image.frames.empty();
  return isPossible ? DicomHeaderResult(std::move(image)) : DicomHeaderResult("it is damaged");
}

}

DicomParserProcess::DicomParserProcess(fs::path program, const DicomParserLimits& limits)
  : Program(std::move(program))
  , Limits(limits)
{
}

DicomParserProcess::~DicomParserProcess() = default;

std::unique_ptr<ChildProcess>& DicomParserProcess::GetChild()
{
  if (!this->Child)
  {
    this->Child = std::make_unique<ChildProcess>(
      std::vector<std::string>{ this->Program.u8string() }, this->Voxels);
  }
  return this->Child;
}

void DicomParserProcess::CountIfTooLong(ConversationEnd end, const fs::path& file)
{
  if (end == ConversationEnd::TooLong && ++this->TimesTooLong > 1)
  {
    throw VolumeReadingError(
      "the DICOM library does not come to an end with its file " + file.u8string());
  }
}

DicomParserProcess::VoxelAnswers DicomParserProcess::AskForVoxels(
  const DicomRequest& request, const ReadingProgress& progress)
{
  VoxelAnswers answers;
  const auto answer = [&answers](const json& message)
  {
    if (message.contains(DicomAnswer::Failure))
    {
      message.at(DicomAnswer::Failure).get_to(answers.failure);
      if (message.contains(DicomAnswer::FailedFile))
      {
        answers.file = message.at(DicomAnswer::FailedFile).get<std::size_t>();
      }
      return;
    }
    answers.read = { message.at(DicomAnswer::ScalarType), message.at(DicomAnswer::Filled) };
  };
  DicomConversation conversation(request, this->Limits.seconds);
  answers.end = conversation.Hold(this->GetChild(), answer, progress);
  const bool saysNothing = !answers.read && answers.failure.empty();
  if (answers.end == ConversationEnd::Done && saysNothing)
  {
    answers.end = ConversationEnd::Crashed;
  }
  if (answers.end != ConversationEnd::Done)
  {
    answers.read.reset();
    answers.file = conversation.GetStarted();
    answers.failure = ReasonOf(answers.end);
  }
  return answers;
}

ConversationEnd DicomParserProcess::AskForHeaders(const std::vector<fs::path>& paths,
  const ReadingProgress& progress, std::vector<DicomHeaderResult>& results)
{
  const auto first = static_cast<std::ptrdiff_t>(results.size());
  DicomRequest request;
  std::transform(paths.begin() + first, paths.end(), std::back_inserter(request.files),
    [](const fs::path& path) {
      return DicomFile{ path, {} };
    });
  request.memoryLimit = MemoryForHeaders(request, this->Limits);
  const auto answer = [&results, &paths](const json& message)
  {
    if (results.size() < paths.size())
    {
      results.push_back(ResultFromMessage(message));
    }
  };
  const auto restProgress = [&](double rest)
  {
    const auto done = static_cast<double>(first);
    const auto all = static_cast<double>(paths.size());
    return progress((done + rest * (all - done)) / all);
  };
  DicomConversation conversation(request, this->Limits.seconds);
  const ConversationEnd end = conversation.Hold(this->GetChild(), answer, restProgress);
  // Where not even the first file was started, the program itself is what fails.
  if (!conversation.GetStarted())
  {
    throw VolumeReadingError("the program " + this->Program.u8string() + " that parses it " +
      (end == ConversationEnd::TooLong ? "hangs" : "fails"));
  }
  return end;
}

std::vector<DicomHeaderResult> DicomParserProcess::ReadHeaders(
  const std::vector<fs::path>& paths, const ReadingProgress& progress)
{
  std::vector<DicomHeaderResult> results;
  while (results.size() < paths.size())
  {
    const std::size_t first = results.size();
    const ConversationEnd end = this->AskForHeaders(paths, progress, results);
    const bool isDone = end == ConversationEnd::Done && results.size() > first;
    if (!isDone && results.size() < paths.size())
    {
      this->CountIfTooLong(end, paths[results.size()]);
      results.push_back(ReasonOf(end));
    }
  }
  return results;
}

std::vector<fs::path> DicomParserProcess::ReadDirectory(const fs::path& path)
{
  DicomRequest request;
  request.task = DicomTask::Directory;
  request.files.push_back({ path, {} });
  request.memoryLimit = MemoryForHeaders(request, this->Limits);
  std::vector<fs::path> files;
  std::string failure;
  const auto answer = [&files, &failure](const json& message)
  {
    if (message.contains(DicomAnswer::Failure))
    {
      message.at(DicomAnswer::Failure).get_to(failure);
      return;
    }
    for (const json& file : message.at(DicomAnswer::Files))
    {
      files.push_back(PathFromMessage(file));
    }
  };
  DicomConversation conversation(request, this->Limits.seconds);
  const ConversationEnd end =
    conversation.Hold(this->GetChild(), answer, [](double) { return true; });
  if (end != ConversationEnd::Done || !failure.empty())
  {
    throw VolumeReadingError(failure.empty() ? ReasonOf(end) : failure);
  }
  return files;
}

DicomVoxelArray DicomParserProcess::ReadVoxels(
  const std::vector<DicomFile>& files, const DicomVolumePlan& plan, const ReadingProgress& progress)
{
  DicomRequest request;
  request.task = DicomTask::Voxels;
  request.files = files;
  request.plan = plan;
  VoxelAnswers answers;
  // Which of several files at once a parser has ended with is not known, so that they are then
  // parsed one by one.
  for (const bool inParallel : { true, false })
  {
    request.inParallel = inParallel;
    request.memoryLimit = MemoryForVoxels(request, this->Limits);
    answers = this->AskForVoxels(request, progress);
    if (answers.end == ConversationEnd::Done)
    {
      break;
    }
    this->Voxels = SharedMemory();
  }
  if (answers.read)
  {
    // The memory belongs to these voxels from now on, and the parser that has it with it.
    this->Child.reset();
    SharedMemory voxels = std::exchange(this->Voxels, SharedMemory());
    voxels.Map();
    const auto count = static_cast<vtkIdType>(NumberOfVoxels(plan.geometry, 1));
    return { MakeSharedArray(std::move(voxels), answers.read->scalarType, count),
      answers.read->filled };
  }
  if (!answers.file || *answers.file >= files.size())
  {
    throw VolumeReadingError(answers.failure);
  }
  this->CountIfTooLong(answers.end, files[*answers.file].path);
  throw DicomFileError(*answers.file, answers.failure);
}

}
