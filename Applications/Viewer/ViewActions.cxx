#include "ViewActions.h"

#include "SceneDocument.h"
#include "Theme.h"
#include "ViewDecorations.h"
#include "VisibleView.h"
#include "VolumeView.h"

#include <QActionGroup>
#include <QMenu>
#include <QSettings>
#include <QStyle>
#include <QToolBar>
#include <QWidget>

#include <vtkImageData.h>
#include <vtkMath.h>

#include <cmath>

namespace penumbra
{
namespace
{
struct Direction
{
  const char* Name;
  const char* Keys;
  /// From the volume to the eye, and up; in a patient's axes x is the left, y the back, z the head.
  Vector3 ToEye;
  Vector3 Up;
};

const Direction Directions[] = {
  { QT_TRANSLATE_NOOP("ViewActions", "From the &front (A)"), "1", { 0, -1, 0 }, { 0, 0, 1 } },
  { QT_TRANSLATE_NOOP("ViewActions", "From the &back (P)"), "2", { 0, 1, 0 }, { 0, 0, 1 } },
  { QT_TRANSLATE_NOOP("ViewActions", "From the patient's &left (L)"), "3", { 1, 0, 0 },
    { 0, 0, 1 } },
  { QT_TRANSLATE_NOOP("ViewActions", "From the patient's &right (R)"), "4", { -1, 0, 0 },
    { 0, 0, 1 } },
  { QT_TRANSLATE_NOOP("ViewActions", "From &above (S)"), "5", { 0, 0, 1 }, { 0, -1, 0 } },
  { QT_TRANSLATE_NOOP("ViewActions", "From b&elow (I)"), "6", { 0, 0, -1 }, { 0, -1, 0 } },
};
}

//------------------------------------------------------------------------------
ViewActions::ViewActions(SceneDocument* document, VolumeView* view, QObject* parent)
  : QObject(parent)
  , Document(document)
  , View(view)
{
}

//------------------------------------------------------------------------------
void ViewActions::Fill(QMenu* menu, QToolBar* bar)
{
  QAction* reset = menu->addAction(tr("&Reset camera"));
  reset->setShortcut(tr("R"));
  reset->setToolTip(tr("Show all of what is visible from the front (R)"));
  reset->setIcon(this->View->style()->standardIcon(QStyle::SP_BrowserReload));
  this->connect(reset, &QAction::triggered, this,
    [this]
    {
      if (this->Document->IsOpen())
      {
        SceneDescription scene = this->Document->GetScene();
        scene.Image.Size = this->View->GetPictureSize();
        ViewFromTheFront(scene, this->Document->GetVoxels().Volume);
        this->View->SetCamera(scene.Camera);
      }
    });
  reset->setEnabled(false);
  this->connect(this->Document, &SceneDocument::opened, reset, [=] { reset->setEnabled(true); });
  bar->addAction(reset);
  this->FillDirections(menu->addMenu(tr("Look &from")));
  QAction* parallel = menu->addAction(tr("&Parallel projection"));
  parallel->setCheckable(true);
  parallel->setToolTip(tr("Without perspective: equal lengths look equal near and far"));
  this->connect(parallel, &QAction::triggered, this, &ViewActions::ToggleParallel);
  this->AddToggle(menu, tr("&Orientation cube"),
    tr("A cube that turns with the volume: L and R, A and P, S and I are the patient's sides"),
    &ViewDecorations::ShowOrientation);
  this->AddToggle(menu, tr("&Scale bar"), tr("A length at the distance that the camera looks at"),
    &ViewDecorations::ShowScaleBar);
  menu->addSeparator();
  this->FillTheme(menu->addMenu(tr("&Theme")));
}

//------------------------------------------------------------------------------
void ViewActions::FillDirections(QMenu* menu)
{
  for (const Direction& direction : Directions)
  {
    QAction* action = menu->addAction(tr(direction.Name));
    action->setShortcut(QKeySequence(direction.Keys));
    this->connect(action, &QAction::triggered, this,
      [this, &direction]
      {
        if (this->Document->IsOpen())
        {
          CameraDescription camera = this->View->GetCamera();
          const double distance = Length(Difference(*camera.Position, *camera.FocalPoint));
          camera.Position = Sum(*camera.FocalPoint, Scaled(direction.ToEye, distance));
          camera.ViewUp = direction.Up;
          this->View->SetCamera(camera);
        }
      });
  }
}

//------------------------------------------------------------------------------
void ViewActions::ToggleParallel(bool parallel)
{
  if (!this->Document->IsOpen())
  {
    return;
  }
  CameraDescription camera = this->View->GetCamera();
  const double distance = Length(Difference(*camera.Position, *camera.FocalPoint));
  const double halfAngle = vtkMath::RadiansFromDegrees(camera.ViewAngle) / 2.0;
  camera.ParallelScale.reset();
  if (parallel)
  {
    camera.ParallelScale = distance * std::tan(halfAngle);
  }
  this->View->SetCamera(camera);
}

//------------------------------------------------------------------------------
void ViewActions::AddToggle(
  QMenu* menu, const QString& text, const QString& tip, void (ViewDecorations::*show)(bool))
{
  QAction* action = menu->addAction(text);
  action->setCheckable(true);
  action->setChecked(true);
  action->setToolTip(tip);
  this->connect(action, &QAction::toggled, this,
    [=](bool shown)
    {
      (this->View->GetDecorations()->*show)(shown);
      this->View->ScheduleFrame();
    });
}

//------------------------------------------------------------------------------
void ViewActions::FillTheme(QMenu* menu)
{
  auto* const group = new QActionGroup(menu);
  const QString names[] = { tr("Like the &system"), tr("&Light"), tr("&Dark") };
  const int chosen = QSettings().value("theme", 0).toInt();
  for (int theme = 0; theme < 3; ++theme)
  {
    QAction* action = group->addAction(names[theme]);
    action->setCheckable(true);
    action->setChecked(theme == chosen);
    menu->addAction(action);
    this->connect(action, &QAction::triggered, this,
      [theme]
      {
        QSettings().setValue("theme", theme);
        ApplyTheme(static_cast<Theme>(theme));
      });
  }
}

}
