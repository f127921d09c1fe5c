/**
 * @file    StepFigures.h
 * @brief   what the length of the steps along rays means for error and time, as the study measured
 *
 * Medians over the eight scenes of Data/study/error.md, by shadow rays, with straight lines between
 * the steps that were measured where both axes are logarithmic. Steps are in smallest spacings.
 */

#ifndef StepFigures_h
#define StepFigures_h

namespace penumbra
{

/// The longest and the shortest step that the slider offers.
///@{
constexpr double LongestStep = 2.0;
constexpr double ShortestStep = 0.125;
///@}

/// Root mean square error of a picture against the reference, in grey levels of 255.
double TypicalError(double step);

/// The step whose typical error this is, from LongestStep to ShortestStep.
double StepOfTypicalError(double error);

/// Of a picture with this step, as a multiple of one with steps of half a spacing.
double TypicalTime(double step);

}

#endif
