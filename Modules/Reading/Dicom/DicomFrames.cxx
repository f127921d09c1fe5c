#include "DicomFrames.h"

#include "DicomTags.h"
#include "NumberText.h"
#include "VolumeReadingError.h"
#include "vtkMath.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

namespace penumbra
{

namespace
{

// Even where frames are compressed, each is an item with a tag and a length.
constexpr double FewestBytesPerFrame = 8.0;

// Kinds of images whose frames follow each other in time.
constexpr std::array<const char*, 6> CineModalities{ "XA", "RF", "US", "IVUS", "ES", "XC" };

// In mm. No scanner is as large: it is a damaged number.
constexpr double FarthestPosition = 1e6;

// Larger slopes and intercepts leave no scalar type that holds the values.
constexpr double LargestRescale = 1e30;

// By what images of one position are told apart, see DicomFrame::order.
enum Order
{
  TemporalPosition,
  EchoTime,
  Acquisition,
  Instance,
  FrameNumber
};

template <typename Value>
void Replace(std::optional<Value>& value, const std::optional<Value>& by)
{
  value = by ? by : value;
}

// Replaces `value` by what the file says, if it says anything.
void ReadFactor(const DicomDataSet& data, const gdcm::Tag& tag, const char* name, double& value)
{
  if (data.Text(tag).empty())
  {
    return;
  }
  const auto factor = data.Decimal(tag);
  if (!factor || std::abs(*factor) > LargestRescale)
  {
    throw VolumeReadingError(
      std::string("its ") + name + " is \"" + data.Text(tag) + "\"; a number is needed");
  }
  value = *factor;
}

void ReadRescale(const DicomDataSet& data, DicomRescale& rescale)
{
  ReadFactor(data, DicomTags::RescaleSlope, "Rescale Slope", rescale.slope);
  ReadFactor(data, DicomTags::RescaleIntercept, "Rescale Intercept", rescale.intercept);
  ReadFactor(data, DicomTags::DoseGridScaling, "Dose Grid Scaling", rescale.slope);
  if (rescale.slope == 0.0)
  {
    throw VolumeReadingError("its Rescale Slope is 0, by which all values are one");
  }
}

std::optional<Vector3> ReadPosition(const DicomDataSet& data)
{
  const auto position = data.DecimalArray<3>(DicomTags::ImagePositionPatient);
  const bool isUsable = position &&
    std::all_of(position->begin(), position->end(),
      [](double value) { return std::abs(value) <= FarthestPosition; });
  return isUsable ? position : std::nullopt;
}

double ReadTemporalPosition(const DicomDataSet& data)
{
  const auto position = data.Decimal(DicomTags::TemporalPositionIdentifier);
  return position ? *position : data.Decimal(DicomTags::TriggerTime).value_or(0.0);
}

// What stands at the top of the file and holds for all frames.
DicomFrame ReadCommon(const DicomDataSet& data)
{
  DicomFrame frame;
  frame.position = ReadPosition(data);
  frame.orientation = data.DecimalArray<6>(DicomTags::ImageOrientationPatient);
  frame.pixelSpacing = data.DecimalArray<2>(DicomTags::PixelSpacing);
  frame.sliceThickness = data.Decimal(DicomTags::SliceThickness);
  frame.spacingBetweenSlices = data.Decimal(DicomTags::SpacingBetweenSlices);
  ReadRescale(data, frame.rescale);
  frame.order[TemporalPosition] = ReadTemporalPosition(data);
  frame.order[EchoTime] = data.Decimal(DicomTags::EchoTime).value_or(0.0);
  frame.order[Acquisition] = data.Decimal(DicomTags::AcquisitionNumber).value_or(0.0);
  frame.order[Instance] = data.Decimal(DicomTags::InstanceNumber).value_or(0.0);
  return frame;
}

void ReadDetector(const DicomDataSet& data, DicomFrame& frame)
{
  const auto detectors = data.Items(DicomTags::DetectorInformationSequence);
  if (detectors.Size() > 0)
  {
    const DicomDataSet detector = detectors.Item(0);
    Replace(frame.position, ReadPosition(detector));
    Replace(frame.orientation, detector.DecimalArray<6>(DicomTags::ImageOrientationPatient));
  }
}

// Calls `read` with the item of a functional group's sequence, if it is there.
template <typename Read>
void ReadGroup(const DicomDataSet& groups, const gdcm::Tag& tag, const Read& read)
{
  const auto sequence = groups.Items(tag);
  if (sequence.Size() > 0)
  {
    read(sequence.Item(0));
  }
}

void ReadFunctionalGroups(const DicomDataSet& groups, DicomFrame& frame)
{
  ReadGroup(groups, DicomTags::PlanePositionSequence,
    [&frame](const DicomDataSet& item) { frame.position = ReadPosition(item); });
  ReadGroup(groups, DicomTags::PlaneOrientationSequence,
    [&frame](const DicomDataSet& item)
    { Replace(frame.orientation, item.DecimalArray<6>(DicomTags::ImageOrientationPatient)); });
  ReadGroup(groups, DicomTags::PixelMeasuresSequence,
    [&frame](const DicomDataSet& item)
    {
      Replace(frame.pixelSpacing, item.DecimalArray<2>(DicomTags::PixelSpacing));
      Replace(frame.sliceThickness, item.Decimal(DicomTags::SliceThickness));
      Replace(frame.spacingBetweenSlices, item.Decimal(DicomTags::SpacingBetweenSlices));
    });
  ReadGroup(groups, DicomTags::PixelValueTransformationSequence,
    [&frame](const DicomDataSet& item) { ReadRescale(item, frame.rescale); });
  ReadGroup(groups, DicomTags::FrameContentSequence,
    [&frame](const DicomDataSet& item)
    {
      frame.order[TemporalPosition] =
        item.Integer(DicomTags::TemporalPositionIndex).value_or(frame.order[TemporalPosition]);
    });
  ReadGroup(groups, DicomTags::MREchoSequence,
    [&frame](const DicomDataSet& item)
    {
      frame.order[EchoTime] =
        item.Real(DicomTags::EffectiveEchoTime).value_or(frame.order[EchoTime]);
    });
}

bool HasPositionPerFrame(const DicomDataSet& data)
{
  const auto perFrame = data.Items(DicomTags::PerFrameFunctionalGroups);
  return perFrame.Size() > 0 && perFrame.Item(0).Has(DicomTags::PlanePositionSequence);
}

void ReadAllFunctionalGroups(const DicomDataSet& data, std::vector<DicomFrame>& frames)
{
  const auto shared = data.Items(DicomTags::SharedFunctionalGroups);
  const auto perFrame = data.Items(DicomTags::PerFrameFunctionalGroups);
  for (std::size_t index = 0; index < frames.size(); ++index)
  {
    if (shared.Size() > 0)
    {
      ReadFunctionalGroups(shared.Item(0), frames[index]);
    }
    if (index < perFrame.Size())
    {
      ReadFunctionalGroups(perFrame.Item(index), frames[index]);
    }
  }
}

void MoveAlongNormal(DicomFrame& frame, double distance)
{
  const double* row = frame.orientation->data();
  double normal[3];
  vtkMath::Cross(row, row + 3, normal);
  vtkMath::Normalize(normal);
  for (int axis = 0; axis < 3; ++axis)
  {
    (*frame.position)[axis] += distance * normal[axis];
  }
}

// Offsets that start at 0 are along the normal, others are z coordinates of axial slices.
void PlaceByOffsets(std::vector<DicomFrame>& frames, const std::vector<double>& offsets)
{
  const bool areCoordinates = offsets.front() != 0.0;
  for (std::size_t index = 0; index < frames.size(); ++index)
  {
    if (areCoordinates)
    {
      (*frames[index].position)[2] = offsets[index];
    }
    else
    {
      MoveAlongNormal(frames[index], offsets[index]);
    }
  }
}

void PlaceBySliceNumbers(const DicomDataSet& data, std::vector<DicomFrame>& frames)
{
  const DicomFrame& common = frames.front();
  const auto spacing =
    common.spacingBetweenSlices ? common.spacingBetweenSlices : common.sliceThickness;
  if (!spacing || *spacing == 0.0)
  {
    for (DicomFrame& frame : frames)
    {
      frame.position.reset();
    }
    return;
  }
  const std::vector<std::uint32_t> slices = data.Integers(DicomTags::SliceVector);
  for (std::size_t index = 0; index < frames.size(); ++index)
  {
    const double slice = index < slices.size() ? slices[index] - 1.0 : static_cast<double>(index);
    MoveAlongNormal(frames[index], slice * *spacing);
  }
}

void RefuseFramesThatAreNoSlices(const DicomDataSet& data)
{
  bool areMoments = data.Has(DicomTags::FrameTime) || data.Has(DicomTags::FrameTimeVector);
  bool areNuclear = false;
  for (const gdcm::Tag& pointer : data.Tags(DicomTags::FrameIncrementPointer))
  {
    areMoments =
      areMoments || pointer == DicomTags::FrameTime || pointer == DicomTags::FrameTimeVector;
    areNuclear = areNuclear || pointer.GetGroup() == DicomTags::SliceVector.GetGroup();
  }
  const std::string modality = data.Text(DicomTags::Modality);
  areMoments = areMoments ||
    std::find(CineModalities.begin(), CineModalities.end(), modality) != CineModalities.end();
  if (areMoments)
  {
    throw VolumeReadingError("its frames are moments in time, not slices of a volume");
  }
  if (areNuclear && !data.Has(DicomTags::SliceVector))
  {
    throw VolumeReadingError("its frames are views or phases, not slices of a volume");
  }
}

void PlaceFrames(const DicomDataSet& data, std::vector<DicomFrame>& frames)
{
  const std::vector<double> offsets = data.Decimals(DicomTags::GridFrameOffsetVector);
  const bool isPlaced = frames.front().position && frames.front().orientation;
  if (isPlaced && offsets.size() == frames.size())
  {
    PlaceByOffsets(frames, offsets);
    return;
  }
  RefuseFramesThatAreNoSlices(data);
  if (isPlaced)
  {
    PlaceBySliceNumbers(data, frames);
  }
}

}

std::vector<DicomFrame> ReadDicomFrames(const DicomDataSet& data, std::uint64_t fileSize)
{
  const double count = data.Decimal(DicomTags::NumberOfFrames).value_or(1.0);
  if (count * FewestBytesPerFrame > static_cast<double>(fileSize))
  {
    throw VolumeReadingError("it says that it has " + NumberText(count) + " frames, but it has " +
      std::to_string(fileSize) + " bytes");
  }
  DicomFrame common = ReadCommon(data);
  ReadDetector(data, common);
  const auto atDetector = data.DecimalArray<2>(DicomTags::ImagerPixelSpacing);
  std::vector<DicomFrame> frames(static_cast<std::size_t>(std::max(count, 1.0)), common);
  for (std::size_t index = 0; index < frames.size(); ++index)
  {
    frames[index].order[FrameNumber] = static_cast<double>(index);
  }
  ReadAllFunctionalGroups(data, frames);
  for (DicomFrame& frame : frames)
  {
    frame.isSpacingAtDetector = !frame.pixelSpacing && atDetector;
    frame.pixelSpacing = frame.pixelSpacing ? frame.pixelSpacing : atDetector;
  }
  if (frames.size() > 1 && !HasPositionPerFrame(data))
  {
    PlaceFrames(data, frames);
  }
  return frames;
}

}
