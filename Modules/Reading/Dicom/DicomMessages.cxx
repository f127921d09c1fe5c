#include "DicomMessages.h"

#include <cstdint>
#include <utility>

using nlohmann::json;

namespace penumbra
{

namespace
{

constexpr std::size_t LengthBytes = 4;

template <typename Value>
json Optional(const std::optional<Value>& value)
{
  return value ? json(*value) : json();
}

template <typename Value>
void Take(const json& message, std::optional<Value>& value)
{
  value = message.is_null() ? std::nullopt : std::optional<Value>(message.get<Value>());
}

json FrameMessage(const DicomFrame& frame)
{
  return json::array(
    { Optional(frame.position), Optional(frame.orientation), Optional(frame.pixelSpacing),
      Optional(frame.sliceThickness), Optional(frame.spacingBetweenSlices), frame.rescale.slope,
      frame.rescale.intercept, frame.order, frame.isSpacingAtDetector });
}

DicomFrame FrameFromMessage(const json& message)
{
  DicomFrame frame;
  Take(message.at(0), frame.position);
  Take(message.at(1), frame.orientation);
  Take(message.at(2), frame.pixelSpacing);
  Take(message.at(3), frame.sliceThickness);
  Take(message.at(4), frame.spacingBetweenSlices);
  message.at(5).get_to(frame.rescale.slope);
  message.at(6).get_to(frame.rescale.intercept);
  message.at(7).get_to(frame.order);
  message.at(8).get_to(frame.isSpacingAtDetector);
  return frame;
}

json PixelMessage(const DicomPixelFormat& pixel)
{
  return json::array({ pixel.bitsAllocated, pixel.bitsStored, pixel.highBit, pixel.isSigned });
}

DicomPixelFormat PixelFromMessage(const json& message)
{
  DicomPixelFormat pixel;
  message.at(0).get_to(pixel.bitsAllocated);
  message.at(1).get_to(pixel.bitsStored);
  message.at(2).get_to(pixel.highBit);
  message.at(3).get_to(pixel.isSigned);
  return pixel;
}

json FileMessage(const DicomFile& file, bool withImage)
{
  return json::array({ ToMessage(file.path), withImage ? ToMessage(file.image) : json() });
}

DicomFile FileFromMessage(const json& message)
{
  DicomFile file;
  file.path = PathFromMessage(message.at(0));
  if (!message.at(1).is_null())
  {
    file.image = ImageFromMessage(message.at(1));
  }
  return file;
}

json PlanMessage(const DicomVolumePlan& plan)
{
  json sources = json::array();
  for (const DicomSource& source : plan.sources)
  {
    sources.push_back(json::array({ source.file, source.frame }));
  }
  json slices = json::array();
  for (const DicomVolumeSlice& slice : plan.slices)
  {
    slices.push_back(json::array({ slice.below, slice.above, slice.weight }));
  }
  return json::array({ plan.geometry.dimensions, std::move(sources), std::move(slices) });
}

DicomVolumePlan PlanFromMessage(const json& message)
{
  DicomVolumePlan plan;
  message.at(0).get_to(plan.geometry.dimensions);
  for (const json& source : message.at(1))
  {
    plan.sources.push_back({ source.at(0), source.at(1), 0.0 });
  }
  for (const json& slice : message.at(2))
  {
    plan.slices.push_back({ slice.at(0), slice.at(1), slice.at(2) });
  }
  return plan;
}

}

json ToMessage(const DicomRequest& request)
{
  json files = json::array();
  for (const DicomFile& file : request.files)
  {
    files.push_back(FileMessage(file, request.task == DicomTask::Voxels));
  }
  return json::array({ static_cast<int>(request.task), std::move(files), PlanMessage(request.plan),
    request.inParallel, request.memoryLimit });
}

DicomRequest RequestFromMessage(const json& message)
{
  DicomRequest request;
  request.task = static_cast<DicomTask>(message.at(0).get<int>());
  for (const json& file : message.at(1))
  {
    request.files.push_back(FileFromMessage(file));
  }
  request.plan = PlanFromMessage(message.at(2));
  message.at(3).get_to(request.inParallel);
  message.at(4).get_to(request.memoryLimit);
  return request;
}

json ToMessage(const DicomImage& image)
{
  json frames = json::array();
  for (const DicomFrame& frame : image.frames)
  {
    frames.push_back(FrameMessage(frame));
  }
  return json::array({ image.seriesInstanceUID, image.studyInstanceUID, image.frameOfReferenceUID,
    image.seriesNumber, image.seriesDescription, image.modality, image.units, image.columns,
    image.rows, PixelMessage(image.pixel), image.isInverted, image.isTurnedOver,
    Optional(image.padding), std::move(frames) });
}

DicomImage ImageFromMessage(const json& message)
{
  DicomImage image;
  message.at(0).get_to(image.seriesInstanceUID);
  message.at(1).get_to(image.studyInstanceUID);
  message.at(2).get_to(image.frameOfReferenceUID);
  message.at(3).get_to(image.seriesNumber);
  message.at(4).get_to(image.seriesDescription);
  message.at(5).get_to(image.modality);
  message.at(6).get_to(image.units);
  message.at(7).get_to(image.columns);
  message.at(8).get_to(image.rows);
  image.pixel = PixelFromMessage(message.at(9));
  message.at(10).get_to(image.isInverted);
  message.at(11).get_to(image.isTurnedOver);
  Take(message.at(12), image.padding);
  for (const json& frame : message.at(13))
  {
    image.frames.push_back(FrameFromMessage(frame));
  }
  return image;
}

json ToMessage(const std::filesystem::path& path)
{
  const std::string text = path.u8string();
  return json::binary({ text.begin(), text.end() });
}

std::filesystem::path PathFromMessage(const json& message)
{
  const auto& bytes = message.get_binary();
  return std::filesystem::u8path(std::string(bytes.begin(), bytes.end()));
}

std::string Encode(const json& message)
{
  const std::vector<std::uint8_t> body = json::to_cbor(message);
  std::string bytes;
  for (std::size_t index = 0; index < LengthBytes; ++index)
  {
    bytes += static_cast<char>((body.size() >> (8 * index)) & 0xff);
  }
  return bytes.append(body.begin(), body.end());
}

std::optional<json> TakeMessage(std::string& bytes)
{
  if (bytes.size() < LengthBytes)
  {
    return std::nullopt;
  }
  std::size_t length = 0;
  for (std::size_t index = 0; index < LengthBytes; ++index)
  {
    length |= static_cast<std::size_t>(static_cast<unsigned char>(bytes[index])) << (8 * index);
  }
  if (bytes.size() < LengthBytes + length)
  {
    return std::nullopt;
  }
  const auto start = bytes.begin() + LengthBytes;
  json message = json::from_cbor(start, start + static_cast<std::ptrdiff_t>(length));
  bytes.erase(0, LengthBytes + length);
  return message;
}

}
