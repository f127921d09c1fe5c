/**
 * @class   LocalDicomParser
 * @brief   parses DICOM files in this process, which some malformed files end
 */

#ifndef LocalDicomParser_h
#define LocalDicomParser_h

#include "DicomParser.h"

namespace penumbra
{

class LocalDicomParser : public DicomParser
{
public:
  std::vector<DicomHeaderResult> ReadHeaders(
    const std::vector<std::filesystem::path>& paths, const ReadingProgress& progress) override;
  std::vector<std::filesystem::path> ReadDirectory(const std::filesystem::path& path) override;
  DicomVoxelArray ReadVoxels(const std::vector<DicomFile>& files, const DicomVolumePlan& plan,
    const ReadingProgress& progress) override;
};

/**
 * The image of one file, or why it has none.
 */
DicomHeaderResult TryReadDicomHeader(const std::filesystem::path& path);

}

#endif
