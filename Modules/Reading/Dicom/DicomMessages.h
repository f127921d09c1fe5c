/**
 * @file    DicomMessages.h
 * @brief   what a parser process and the one that started it tell each other
 *
 * A message is CBOR (RFC 8949) after its length, four bytes, least significant first.
 */

#ifndef DicomMessages_h
#define DicomMessages_h

#include "DicomParser.h"

#include <nlohmann/json.hpp>

#include <optional>
#include <string>

namespace penumbra
{

/// What a parser process is asked for.
enum class DicomTask
{
  Headers,
  Directory,
  Voxels
};

struct DicomRequest
{
  DicomTask task = DicomTask::Headers;
  /// Images are needed for voxels only.
  std::vector<DicomFile> files;
  DicomVolumePlan plan;
  /// Whether several files may be parsed at once.
  bool inParallel = false;
  /// In bytes.
  std::size_t memoryLimit = 0;
};

/// Keys of the answers.
namespace DicomAnswer
{
/// The index of the file that is about to be parsed, and how far the task is, 0 to 1.
inline constexpr const char* Start = "start";
inline constexpr const char* Progress = "progress";
/// The image of the file that was started.
inline constexpr const char* Image = "image";
/// Why the file that was started cannot be read; of voxels, why there are none.
inline constexpr const char* Failure = "failure";
/// The index of the file for which there are no voxels, if it is for one.
inline constexpr const char* FailedFile = "failedFile";
/// Paths.
inline constexpr const char* Files = "files";
/// The scalar type of the voxels, as VTK's constant.
inline constexpr const char* ScalarType = "scalarType";
/// How many voxels without a measurement have got the value of another.
inline constexpr const char* Filled = "filled";
/// Without a value: the task is done.
inline constexpr const char* Done = "done";
}

nlohmann::json ToMessage(const DicomRequest& request);
DicomRequest RequestFromMessage(const nlohmann::json& message);

nlohmann::json ToMessage(const DicomImage& image);
DicomImage ImageFromMessage(const nlohmann::json& message);

/// Paths need not be text.
nlohmann::json ToMessage(const std::filesystem::path& path);
std::filesystem::path PathFromMessage(const nlohmann::json& message);

/// With its length.
std::string Encode(const nlohmann::json& message);

/**
 * Takes the first message off `bytes`, if all of it is there. Throws nlohmann::json::exception
 * where it is none.
 */
std::optional<nlohmann::json> TakeMessage(std::string& bytes);

}

#endif
