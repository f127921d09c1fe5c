/**
 * @file    ScrollableArea.h
 * @brief   panels that are longer than their place
 */

#ifndef ScrollableArea_h
#define ScrollableArea_h

class QScrollArea;
class QWidget;

namespace penumbra
{

/// Scrolls its content up and down; the content's width is the area's.
QScrollArea* MakeScrollable(QWidget* content);

}

#endif
