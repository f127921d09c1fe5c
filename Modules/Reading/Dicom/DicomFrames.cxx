#include "DicomFrames.h"

#include "DicomTags.h"
#include "VolumeReadingError.h"
#include "vtkMath.h"

#include <algorithm>

namespace penumbra
{

namespace
{

// A day of video has fewer; more is a damaged number.
constexpr double MostFrames = 1e6;

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

void ReadRescale(const DicomDataSet& data, DicomRescale& rescale)
{
  rescale.slope = data.Decimal(DicomTags::RescaleSlope).value_or(rescale.slope);
  rescale.intercept = data.Decimal(DicomTags::RescaleIntercept).value_or(rescale.intercept);
  rescale.slope = data.Decimal(DicomTags::DoseGridScaling).value_or(rescale.slope);
  // A slope of 0 would leave nothing to see, and is what careless writers put for none.
  rescale.slope = rescale.slope == 0.0 ? 1.0 : rescale.slope;
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
  frame.position = data.DecimalArray<3>(DicomTags::ImagePositionPatient);
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
    Replace(frame.position, detector.DecimalArray<3>(DicomTags::ImagePositionPatient));
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
    [&frame](const DicomDataSet& item)
    { Replace(frame.position, item.DecimalArray<3>(DicomTags::ImagePositionPatient)); });
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

void PlaceByOffsets(std::vector<DicomFrame>& frames, std::vector<double> offsets)
{
  // Offsets that do not start at 0 are positions along the normal of axial slices.
  const double first = offsets.front();
  for (std::size_t index = 0; index < frames.size(); ++index)
  {
    MoveAlongNormal(frames[index], offsets[index] - first);
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

std::vector<DicomFrame> ReadDicomFrames(const DicomDataSet& data)
{
  const double count = data.Decimal(DicomTags::NumberOfFrames).value_or(1.0);
  if (!(count <= MostFrames))
  {
    throw VolumeReadingError("it says that it has " + std::to_string(count) + " frames");
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
