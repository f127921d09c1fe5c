#include "TransferFunctionPanel.h"

#include "GradientOpacityChart.h"
#include "PointTable.h"
#include "SceneDocument.h"
#include "TransferFunctionChart.h"

#include <QCheckBox>
#include <QHBoxLayout>

#include <vtkImageData.h>

namespace penumbra
{
namespace
{
// Of what the chart shows: from here on matter counts as an edge at first.
constexpr double FirstEdge = 0.2;
constexpr int WidthOfPoints = 128;
}

//------------------------------------------------------------------------------
TransferFunctionPanel::TransferFunctionPanel(SceneDocument* document, QWidget* parent)
  : QTabWidget(parent)
  , Document(document)
  , Chart(new TransferFunctionChart(document, this))
{
  this->setObjectName("transferFunctionPages");
  this->setAccessibleName(tr("Transfer function"));
  this->addTab(this->Chart, tr("Chart"));
  this->addTab(this->MakePointPage(), tr("Points"));
  this->addTab(this->MakeGradientPage(), tr("Gradient"));
  this->connect(document, &SceneDocument::changed, this, &TransferFunctionPanel::Refresh);
}

//------------------------------------------------------------------------------
QWidget* TransferFunctionPanel::MakePointPage()
{
  auto* const page = new QWidget(this);
  auto* const row = new QHBoxLayout(page);
  row->setContentsMargins(4, 4, 4, 4);
  row->addWidget(new PointTable(tr("Points of opacity"), this->Document, AccessToOpacity(), page));
  row->addWidget(new PointTable(tr("Points of colour"), this->Document, AccessToColor(), page));
  return page;
}

//------------------------------------------------------------------------------
QWidget* TransferFunctionPanel::MakeGradientPage()
{
  auto* const page = new QWidget(this);
  auto* const column = new QVBoxLayout(page);
  column->setContentsMargins(4, 4, 4, 4);
  this->GradientSwitch = new QCheckBox(tr("Fade matter without edges"), page);
  this->GradientSwitch->setObjectName("gradientSwitch");
  this->GradientSwitch->setToolTip(
    tr("Make matter transparent where values change little, so that surfaces stay and what fills "
       "them goes. The gradient is in the volume's values per voxel."));
  column->addWidget(this->GradientSwitch);
  this->GradientEditor = new QWidget(page);
  auto* const row = new QHBoxLayout(this->GradientEditor);
  row->setContentsMargins(0, 0, 0, 0);
  this->GradientChart = new GradientOpacityChart(this->Document, this->GradientEditor);
  row->addWidget(this->GradientChart, 1);
  auto* const points = new PointTable(tr("Points of gradient opacity"), this->Document,
    AccessToGradientOpacity(), this->GradientEditor);
  points->setFixedWidth(WidthOfPoints);
  row->addWidget(points);
  column->addWidget(this->GradientEditor, 1);
  this->GradientEditor->setEnabled(false);
  this->connect(
    this->GradientSwitch, &QCheckBox::clicked, this, &TransferFunctionPanel::SwitchGradient);
  return page;
}

//------------------------------------------------------------------------------
void TransferFunctionPanel::SwitchGradient(bool on)
{
  this->Document->Edit(on ? tr("gradient opacity on") : tr("gradient opacity off"),
    [=](SceneDescription& scene)
    {
      scene.TransferFunction.GradientOpacity.reset();
      if (on)
      {
        const double last = LargestGradientOfChart(this->Document->GetVoxels().Volume);
        scene.TransferFunction.GradientOpacity = { { 0.0, 0.0 }, { FirstEdge * last, 1.0 },
          { last, 1.0 } };
      }
    });
}

//------------------------------------------------------------------------------
void TransferFunctionPanel::Refresh()
{
  const bool on = this->Document->GetScene().TransferFunction.GradientOpacity.has_value();
  this->GradientSwitch->setChecked(on);
  this->GradientEditor->setEnabled(on);
}

}
