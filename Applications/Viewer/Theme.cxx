#include "Theme.h"

#include <QApplication>
#include <QPainter>
#include <QPalette>
#include <QProxyStyle>
#include <QStyleOption>

namespace penumbra
{
namespace
{
constexpr QRgb Accent = 0x3d8bd4;
constexpr int TabPadding = 10;
constexpr double EdgeOpacity = 0.5;

// The titles of a narrow window's tabs have room beside each other, and boxes that are not checked
// are seen on dark menus too.
class ThemeStyle : public QProxyStyle
{
public:
  ThemeStyle()
    : QProxyStyle(StyleName)
  {
  }

  int pixelMetric(
    PixelMetric metric, const QStyleOption* option, const QWidget* widget) const override
  {
    return metric == PM_TabBarTabHSpace ? TabPadding
                                        : QProxyStyle::pixelMetric(metric, option, widget);
  }

  void drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
    const QWidget* widget) const override
  {
    QProxyStyle::drawPrimitive(element, option, painter, widget);
    if (element == PE_IndicatorCheckBox)
    {
      QColor edge = option->palette.color(QPalette::Text);
      edge.setAlphaF(EdgeOpacity);
      painter->save();
      painter->setPen(edge);
      painter->setBrush(Qt::NoBrush);
      painter->drawRect(option->rect.adjusted(0, 0, -1, -1));
      painter->restore();
    }
  }
};

QPalette MakePalette(QRgb window, QRgb base, QRgb button, QRgb text, QRgb faint, QRgb tip)
{
  // Colours of edges follow from these two.
  QPalette palette{ QColor(button), QColor(window) };
  palette.setColor(QPalette::Base, QColor(base));
  palette.setColor(QPalette::AlternateBase, QColor(window));
  palette.setColor(QPalette::Button, QColor(button));
  palette.setColor(QPalette::ToolTipBase, QColor(tip));
  palette.setColor(QPalette::Highlight, QColor(Accent));
  palette.setColor(QPalette::HighlightedText, Qt::white);
  palette.setColor(QPalette::Link, QColor(Accent));
  for (const auto role : { QPalette::WindowText, QPalette::Text, QPalette::ButtonText,
         QPalette::ToolTipText, QPalette::BrightText })
  {
    palette.setColor(role, QColor(text));
    palette.setColor(QPalette::Disabled, role, QColor(faint));
  }
  palette.setColor(QPalette::PlaceholderText, QColor(faint));
  palette.setColor(QPalette::Disabled, QPalette::Highlight, QColor(faint));
  return palette;
}

QPalette PaletteOf(bool dark)
{
  return dark ? MakePalette(0x2b2e33, 0x191b1e, 0x3a3e45, 0xe4e6e9, 0x7c828a, 0x3a3f46)
              : MakePalette(0xf1f2f4, 0xffffff, 0xf7f8f9, 0x202327, 0x9a9fa6, 0xffffe8);
}

// Before any theme was applied, the palette is the system's.
bool IsSystemDark()
{
  static const bool dark = QApplication::palette().color(QPalette::Window).lightness() <
    QApplication::palette().color(QPalette::WindowText).lightness();
  return dark;
}
}

//------------------------------------------------------------------------------
void ApplyTheme(Theme theme)
{
  const bool systemDark = IsSystemDark();
  const bool dark = theme == Theme::Dark || (theme == Theme::System && systemDark);
  QApplication::setStyle(new ThemeStyle);
  QApplication::setPalette(PaletteOf(dark));
}

}
