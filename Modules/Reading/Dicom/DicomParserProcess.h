/**
 * @class   DicomParserProcess
 * @brief   parses DICOM files in a process of its own, with limits
 *
 * A file on which that process crashes, or spends too long, is one that cannot be read. Voxels come
 * back in memory that both processes share, so that they are not copied.
 */

#ifndef DicomParserProcess_h
#define DicomParserProcess_h

#include "ChildProcess.h"
#include "DicomConversation.h"
#include "DicomParser.h"
#include "DicomVoxels.h"
#include "SharedMemory.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

namespace penumbra
{

struct DicomParserLimits
{
  /// Bytes of memory for files and voxels, beside what the program needs for itself.
  std::uint64_t memory = 0;
  /// Seconds for one file, and one more for each MiB of it.
  double seconds = 0.0;
};

struct DicomRequest;

class DicomParserProcess : public DicomParser
{
public:
  /**
   * `program` is penumbra-dicom-parser.
   */
  DicomParserProcess(std::filesystem::path program, const DicomParserLimits& limits);

  ~DicomParserProcess() override;

  std::vector<DicomHeaderResult> ReadHeaders(
    const std::vector<std::filesystem::path>& paths, const ReadingProgress& progress) override;
  std::vector<std::filesystem::path> ReadDirectory(const std::filesystem::path& path) override;
  DicomVoxelArray ReadVoxels(const std::vector<DicomFile>& files, const DicomVolumePlan& plan,
    const ReadingProgress& progress) override;

private:
  struct VoxelAnswers
  {
    ConversationEnd end = ConversationEnd::Done;
    std::optional<DicomVoxels> read;
    std::string failure;
    /// Which one fails, unless it is none of them.
    std::optional<std::size_t> file;
  };
  VoxelAnswers AskForVoxels(const DicomRequest& request, const ReadingProgress& progress);

  // For those after `results`, to which what is answered is added.
  ConversationEnd AskForHeaders(const std::vector<std::filesystem::path>& paths,
    const ReadingProgress& progress, std::vector<DicomHeaderResult>& results);

  // One endless file is left out; with the next one the user has waited for long enough.
  void CountIfTooLong(ConversationEnd end, const std::filesystem::path& file);

  // Started if there is none.
  std::unique_ptr<ChildProcess>& GetChild();

  std::filesystem::path Program;
  DicomParserLimits Limits;
  int TimesTooLong = 0;
  SharedMemory Voxels;
  // Kept from one task to the next, for it takes longer to start than many a task.
  std::unique_ptr<ChildProcess> Child;
};

}

#endif
