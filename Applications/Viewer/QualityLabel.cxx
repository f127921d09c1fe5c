#include "QualityLabel.h"

#include "SceneDocument.h"
#include "StepFigures.h"
#include "VolumeBox.h"
#include "VolumeView.h"

#include <vtkImageData.h>

namespace penumbra
{

//------------------------------------------------------------------------------
QualityLabel::QualityLabel(SceneDocument* document, VolumeView* view, QWidget* parent)
  : QLabel(parent)
  , Document(document)
{
  this->setObjectName("qualityLabel");
  this->setAccessibleName(tr("Error and time"));
  this->setToolTip(
    tr("The error is the median that a study of eight scenes found for steps of this length, as a "
       "root mean square against an exact picture. The time is that of your last whole picture, "
       "scaled where the steps have changed since."));
  this->connect(document, &SceneDocument::opened, this, [this] { this->Seconds = 0.0; });
  this->connect(document, &SceneDocument::changed, this, &QualityLabel::Refresh);
  this->connect(view, &VolumeView::refined, this, &QualityLabel::NoteTime);
}

//------------------------------------------------------------------------------
double QualityLabel::GetStep() const
{
  return *this->Document->GetScene().SampleDistance /
    SmallestSpacing(this->Document->GetVoxels().Volume);
}

//------------------------------------------------------------------------------
void QualityLabel::NoteTime(double seconds)
{
  this->Seconds = seconds;
  this->Step = this->GetStep();
  this->Refresh();
}

//------------------------------------------------------------------------------
void QualityLabel::Refresh()
{
  const double step = this->GetStep();
  QString text = tr("Typical error %1 of 255").arg(TypicalError(step), 0, 'f', 1 + (step < 1.0));
  if (this->Seconds > 0.0)
  {
    const double seconds = this->Seconds * TypicalTime(step) / TypicalTime(this->Step);
    text += tr(", about %1 s").arg(seconds, 0, 'g', 2);
  }
  this->setText(text);
}

}
