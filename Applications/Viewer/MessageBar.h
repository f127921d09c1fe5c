/**
 * @class   MessageBar
 * @brief   a message over the top of its parent that waits for nobody
 *
 * It covers a little and moves nothing, so that nothing is drawn anew for it.
 */

#ifndef MessageBar_h
#define MessageBar_h

#include <QFrame>

class QLabel;

namespace penumbra
{

class MessageBar : public QFrame
{
  Q_OBJECT
public:
  explicit MessageBar(QWidget* parent);

  void ShowError(const QString& text);
  void ShowNotice(const QString& text);
  /// Of the message that is shown; empty where there is none.
  QString GetText() const;

protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

private:
  void Place();
  void ShowText(const QString& text, const QColor& color);

  QLabel* Label;
};

}

#endif
