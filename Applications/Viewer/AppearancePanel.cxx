#include "AppearancePanel.h"

#include "PresetPanel.h"
#include "PropertyForm.h"
#include "RenderingForm.h"
#include "SceneDocument.h"
#include "ScrollableArea.h"
#include "TransferFunctionPanel.h"

#include <QScrollArea>
#include <QSplitter>
#include <QVBoxLayout>

namespace penumbra
{

//------------------------------------------------------------------------------
AppearancePanel::AppearancePanel(SceneDocument* document, VolumeView* view, QWidget* parent)
  : QWidget(parent)
  , Presets(new PresetPanel(document, view, this))
  , TransferFunction(new TransferFunctionPanel(document, this))
{
  auto* const column = new QVBoxLayout(this);
  column->setContentsMargins(6, 6, 6, 6);
  auto* const splitter = new QSplitter(Qt::Vertical, this);
  splitter->setChildrenCollapsible(false);
  splitter->addWidget(this->Presets);
  splitter->addWidget(this->TransferFunction);
  auto* const material = new PropertyForm(document, this);
  FillMaterialForm(material, document);
  material->Refresh();
  QScrollArea* area = MakeScrollable(material);
  area->setMinimumHeight(90);
  splitter->addWidget(area);
  splitter->setStretchFactor(1, 1);
  splitter->setSizes({ 190, 220, 200 });
  column->addWidget(splitter);
}

}
