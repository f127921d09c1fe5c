#include "ScrollableArea.h"

#include <QScrollArea>

namespace penumbra
{

//------------------------------------------------------------------------------
QScrollArea* MakeScrollable(QWidget* content)
{
  auto* const area = new QScrollArea;
  area->setWidget(content);
  area->setWidgetResizable(true);
  area->setFrameShape(QFrame::NoFrame);
  area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  return area;
}

}
