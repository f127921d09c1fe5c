/**
 * @file    DicomTags.h
 * @brief   the attributes that are read, by the names of DICOM PS3.6
 */

#ifndef DicomTags_h
#define DicomTags_h

#include <gdcmTag.h>

namespace penumbra
{
namespace DicomTags
{

inline const gdcm::Tag DirectoryRecordSequence(0x0004, 0x1220);
inline const gdcm::Tag ReferencedFileID(0x0004, 0x1500);
inline const gdcm::Tag ImageType(0x0008, 0x0008);
inline const gdcm::Tag SOPClassUID(0x0008, 0x0016);
inline const gdcm::Tag Modality(0x0008, 0x0060);
inline const gdcm::Tag SeriesDescription(0x0008, 0x103e);
inline const gdcm::Tag SliceThickness(0x0018, 0x0050);
inline const gdcm::Tag EchoTime(0x0018, 0x0081);
inline const gdcm::Tag SpacingBetweenSlices(0x0018, 0x0088);
inline const gdcm::Tag TriggerTime(0x0018, 0x1060);
inline const gdcm::Tag FrameTime(0x0018, 0x1063);
inline const gdcm::Tag FrameTimeVector(0x0018, 0x1065);
inline const gdcm::Tag ImagerPixelSpacing(0x0018, 0x1164);
inline const gdcm::Tag EffectiveEchoTime(0x0018, 0x9082);
inline const gdcm::Tag MREchoSequence(0x0018, 0x9114);
inline const gdcm::Tag StudyInstanceUID(0x0020, 0x000d);
inline const gdcm::Tag SeriesInstanceUID(0x0020, 0x000e);
inline const gdcm::Tag SeriesNumber(0x0020, 0x0011);
inline const gdcm::Tag AcquisitionNumber(0x0020, 0x0012);
inline const gdcm::Tag InstanceNumber(0x0020, 0x0013);
inline const gdcm::Tag ImagePositionPatient(0x0020, 0x0032);
inline const gdcm::Tag ImageOrientationPatient(0x0020, 0x0037);
inline const gdcm::Tag FrameOfReferenceUID(0x0020, 0x0052);
inline const gdcm::Tag TemporalPositionIdentifier(0x0020, 0x0100);
inline const gdcm::Tag FrameContentSequence(0x0020, 0x9111);
inline const gdcm::Tag PlanePositionSequence(0x0020, 0x9113);
inline const gdcm::Tag PlaneOrientationSequence(0x0020, 0x9116);
inline const gdcm::Tag TemporalPositionIndex(0x0020, 0x9128);
inline const gdcm::Tag SamplesPerPixel(0x0028, 0x0002);
inline const gdcm::Tag PhotometricInterpretation(0x0028, 0x0004);
inline const gdcm::Tag NumberOfFrames(0x0028, 0x0008);
inline const gdcm::Tag FrameIncrementPointer(0x0028, 0x0009);
inline const gdcm::Tag Rows(0x0028, 0x0010);
inline const gdcm::Tag Columns(0x0028, 0x0011);
inline const gdcm::Tag PixelSpacing(0x0028, 0x0030);
inline const gdcm::Tag BitsAllocated(0x0028, 0x0100);
inline const gdcm::Tag BitsStored(0x0028, 0x0101);
inline const gdcm::Tag HighBit(0x0028, 0x0102);
inline const gdcm::Tag PixelRepresentation(0x0028, 0x0103);
inline const gdcm::Tag PixelPaddingValue(0x0028, 0x0120);
inline const gdcm::Tag PixelPaddingRangeLimit(0x0028, 0x0121);
inline const gdcm::Tag RescaleIntercept(0x0028, 0x1052);
inline const gdcm::Tag RescaleSlope(0x0028, 0x1053);
inline const gdcm::Tag RescaleType(0x0028, 0x1054);
inline const gdcm::Tag ModalityLUTSequence(0x0028, 0x3000);
inline const gdcm::Tag PixelMeasuresSequence(0x0028, 0x9110);
inline const gdcm::Tag PixelValueTransformationSequence(0x0028, 0x9145);
inline const gdcm::Tag DetectorInformationSequence(0x0054, 0x0022);
inline const gdcm::Tag SliceVector(0x0054, 0x0080);
inline const gdcm::Tag Units(0x0054, 0x1001);
inline const gdcm::Tag DoseUnits(0x3004, 0x0002);
inline const gdcm::Tag GridFrameOffsetVector(0x3004, 0x000c);
inline const gdcm::Tag DoseGridScaling(0x3004, 0x000e);
inline const gdcm::Tag SharedFunctionalGroups(0x5200, 0x9229);
inline const gdcm::Tag PerFrameFunctionalGroups(0x5200, 0x9230);
inline const gdcm::Tag FloatPixelData(0x7fe0, 0x0008);
inline const gdcm::Tag DoubleFloatPixelData(0x7fe0, 0x0009);
inline const gdcm::Tag PixelData(0x7fe0, 0x0010);

}
}

#endif
