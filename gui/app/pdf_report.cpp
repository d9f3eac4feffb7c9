// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "pdf_report.hpp"

#include "wcam/base/error.hpp"

#include <QAbstractTextDocumentLayout>
#include <QBuffer>
#include <QImage>
#include <QPageLayout>
#include <QPainter>
#include <QPdfWriter>
#include <QRegularExpression>
#include <QSvgRenderer>
#include <QTextDocument>
#include <QThread>
#include <QUrl>

#include <algorithm>
#include <exception>
#include <memory>

namespace wcam::gui {

namespace {

constexpr int kDotsPerInch = 300;
/// Width of the text on an A4 page, and that of a picture in dots and in the pixels of HTML.
constexpr double kTextWidth = 170.0 / 25.4;
constexpr double kPictureWidth = kTextWidth * kDotsPerInch;
constexpr double kHtmlWidth = kTextWidth * 96.0;
constexpr double kMostHeight = 110.0 / 25.4 * 96.0;  ///< of a picture
constexpr int kColumns = 4;

/// Text documents know neither variables nor grids: the page's own style does not serve them.
constexpr const char* kPageStyle = R"(
body{font-family:"DejaVu Sans",sans-serif;font-size:9pt;color:#1c1e21}
h1{font-size:16pt}h2{font-size:13pt}h3{font-size:10pt}
th{color:#5d646d;text-align:left}td.n{text-align:right}
.violation{color:#b3261e;font-weight:600}.warning{color:#9a6700}.information{color:#0550ae}
pre{font-family:"DejaVu Sans Mono",monospace;font-size:7pt}
)";
constexpr const char* kPlotStyle =
    "<style>text{font:11px sans-serif;fill:#5d646d}"
    ".grid{stroke:#d5dae0;stroke-width:0.6}.axis{stroke:#5d646d}"
    ".limit{stroke:#b3261e;stroke-dasharray:5 4}</style>";

QImage plotPicture(QString svg) {
  svg.insert(svg.indexOf('>') + 1, kPlotStyle);
  QSvgRenderer renderer(svg.toUtf8());
  const QSizeF size = renderer.viewBoxF().size();
  if (!renderer.isValid() || size.isEmpty()) {
    throw Error(ErrorCode::Internal, "a plot of the report cannot be drawn");
  }
  QImage image(QSizeF(kPictureWidth, kPictureWidth * size.height() / size.width()).toSize(),
               QImage::Format_RGB32);
  image.fill(Qt::white);
  QPainter painter(&image);
  painter.setRenderHint(QPainter::Antialiasing);
  renderer.render(&painter);
  return image;
}

/// Calls `make` for every match of `pattern` and puts what it gives in its place.
template <class Make>
QString replaced(const QString& text, const QString& pattern, const Make& make) {
  const QRegularExpression expression(pattern, QRegularExpression::DotMatchesEverythingOption |
                                                   QRegularExpression::InvertedGreedinessOption);
  QString result;
  qsizetype at = 0;
  auto matches = expression.globalMatch(text);
  while (matches.hasNext()) {
    const QRegularExpressionMatch match = matches.next();
    result += text.mid(at, match.capturedStart() - at) + make(match);
    at = match.capturedEnd();
  }
  return result + text.mid(at);
}

/// The boxes of figures as a table.
QString figureTable(const QString& boxes) {
  QString cells = "<table width=\"100%\" cellpadding=\"4\"><tr>";
  int count = 0;
  replaced(boxes, "<b>(.*)</b><span>(.*)</span>", [&](const QRegularExpressionMatch& match) {
    if (count > 0 && count % kColumns == 0) {
      cells += "</tr><tr>";
    }
    ++count;
    cells += "<td><b>" + match.captured(1) + "</b><br/><font color=\"#5d646d\">" +
             match.captured(2) + "</font></td>";
    return QString();
  });
  return cells + "</tr></table>";
}

QByteArray print(const std::string& html) {
  QByteArray bytes;
  QBuffer buffer(&bytes);
  buffer.open(QIODevice::WriteOnly);
  QPdfWriter writer(&buffer);
  writer.setResolution(kDotsPerInch);
  writer.setPageSize(QPageSize(QPageSize::A4));
  writer.setPageMargins(QMarginsF(20.0, 15.0, 20.0, 15.0), QPageLayout::Millimeter);
  writer.setCreator("WCAM");

  QTextDocument document;
  document.documentLayout()->setPaintDevice(&writer);
  QString page = QString::fromStdString(html);
  page = replaced(page, "<style>.*</style>", [](const auto&) { return QString(); });
  page = replaced(page, "<div class=\"figures\">(.*)</div></div>",
                  [](const auto& match) { return figureTable(match.captured(1) + "</div>"); });
  int count = 0;
  const auto addPicture = [&](const QImage& image) {
    const QString name = QString("wcam:picture%1").arg(count++);
    document.addResource(QTextDocument::ImageResource, QUrl(name), image);
    const double high = kHtmlWidth * image.height() / std::max(image.width(), 1);
    const double scale = std::min(1.0, kMostHeight / high);
    return QString("<p><img src=\"%1\" width=\"%2\" height=\"%3\"/></p>")
        .arg(name)
        .arg(scale * kHtmlWidth)
        .arg(scale * high);
  };
  page = replaced(page, "<svg .*</svg>",
                  [&](const auto& match) { return addPicture(plotPicture(match.captured(0))); });
  page = replaced(page, "<img [^>]*data:image/png;base64,([^\"]*)\"[^>]*>", [&](const auto& match) {
    return addPicture(
        QImage::fromData(QByteArray::fromBase64(match.captured(1).toLatin1()), "PNG"));
  });
  page.replace("<summary>", "<h3>").replace("</summary>", "</h3>");
  page.replace("<table>", "<table width=\"100%\" cellpadding=\"2\">");
  document.setDefaultStyleSheet(kPageStyle);
  document.setHtml(page);
  document.setPageSize(QSizeF(writer.width(), writer.height()));
  document.print(&writer);
  if (bytes.isEmpty()) {
    throw Error(ErrorCode::Internal, "the report cannot be printed");
  }
  return bytes;
}

}  // namespace

QByteArray pdfReport(const std::string& html) {
  // The layout of text wants a thread of Qt's own.
  QByteArray bytes;
  std::exception_ptr failed;
  const std::unique_ptr<QThread> thread(QThread::create([&] {
    try {
      bytes = print(html);
    } catch (...) {
      failed = std::current_exception();
    }
  }));
  thread->start();
  thread->wait();
  if (failed) {
    std::rethrow_exception(failed);
  }
  return bytes;
}

}  // namespace wcam::gui
