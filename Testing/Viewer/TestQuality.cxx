#include "Catch.h"
#include "NumberBox.h"
#include "StepFigures.h"
#include "ViewerSession.h"

#include <QLabel>

using namespace penumbra;

TEST_CASE("Figures of steps are the study's, and between them in order", "[quality]")
{
  CHECK(TypicalError(0.5) == Approx(0.42)); // Data/study/error.md, the median of "penumbra rays"
  CHECK(TypicalError(2.0) == Approx(4.225));
  CHECK(TypicalError(100.0) == TypicalError(4.0));
  CHECK(TypicalTime(0.5) == Approx(1.0));
  double error = TypicalError(LongestStep);
  double time = TypicalTime(LongestStep);
  for (double step = 1.9; step > ShortestStep; step *= 0.9)
  {
    CAPTURE(step);
    CHECK(TypicalError(step) < error);
    CHECK(TypicalTime(step) > time);
    CHECK(StepOfTypicalError(TypicalError(step)) == Approx(step));
    error = TypicalError(step);
    time = TypicalTime(step);
  }
}

TEST_CASE("Quality is linear in the error, and tells error and time", "[quality]")
{
  ViewerSession session;
  REQUIRE(session.Open(session.Files.File));
  auto* const quality = session.Find<NumberBox>("Quality");
  auto* const label = session.Find<QLabel>("qualityLabel");
  const auto step = [&] { return *session.Document.GetScene().SampleDistance; };
  CHECK(step() == 0.5);
  CHECK_THAT(label->text().toStdString(), Catch::Matchers::Contains("error 0.42 of 255"));
  CHECK_THAT(label->text().toStdString(), Catch::Matchers::Contains(" s"));
  const auto errorOf = [&](double value)
  {
    quality->setValue(value);
    CHECK(*session.Document.GetScene().Shadows.SampleDistance == 2.0 * step());
    CHECK(quality->value() == Approx(value).margin(0.05)); // one decimal
    return TypicalError(step());
  };
  const double most = errorOf(0.0);
  const double middle = errorOf(50.0);
  CHECK(most - middle == Approx(middle - errorOf(100.0)));
  CHECK(step() == Approx(ShortestStep));
  emit session.Window.GetView()->refined(8.0);
  CHECK_THAT(label->text().toStdString(), Catch::Matchers::Contains("about 8 s"));
  quality->setValue(0.0);
  CHECK_THAT(label->text().toStdString(), Catch::Matchers::Contains("about 0."));
}
