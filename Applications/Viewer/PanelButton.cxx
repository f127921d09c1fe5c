#include "PanelButton.h"

#include <QToolButton>

namespace penumbra
{

//------------------------------------------------------------------------------
QToolButton* MakePanelButton(const QString& text, const QString& tip, QWidget* parent)
{
  auto* const button = new QToolButton(parent);
  button->setText(text);
  button->setToolTip(tip);
  button->setAccessibleName(text);
  button->setAccessibleDescription(tip);
  button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  button->setFocusPolicy(Qt::StrongFocus);
  return button;
}

}
