/**
 * @file    PanelButton.h
 * @brief   the buttons beneath a panel's list
 */

#ifndef PanelButton_h
#define PanelButton_h

#include <QString>

class QToolButton;
class QWidget;

namespace penumbra
{

/// A button that shares its row evenly and is reached by the keyboard.
QToolButton* MakePanelButton(const QString& text, const QString& tip, QWidget* parent);

}

#endif
