package dev.eventchain.model.diagram;

import dev.eventchain.diagnostics.Printable;
import dev.eventchain.model.diagram.ChainDiagram.Area;
import dev.eventchain.model.diagram.ChainDiagram.Box;
import dev.eventchain.model.diagram.ChainDiagram.Kind;
import dev.eventchain.model.diagram.ChainDiagram.Line;
import dev.eventchain.model.diagram.ChainDiagram.LineKind;
import dev.eventchain.model.diagram.ChainDiagram.Point;
import dev.eventchain.model.diagram.ChainDiagram.Text;
import java.util.List;
import java.util.Locale;
import java.util.regex.Pattern;

/**
 * Renders a diagram as SVG, in colours suitable for printing. The same diagram gives the same text.
 */
public final class DiagramSvg {

  private static final String LINE = "#39434b";

  /** Characters that XML cannot hold or that nobody sees; breaks of lines are none of them. */
  private static final Pattern INVISIBLE = Pattern.compile("[\\p{C}&&[^\\n\\t]]");

  private final ChainDiagram diagram;
  private final TextSizes sizes;
  private final StringBuilder out = new StringBuilder();

  private DiagramSvg(ChainDiagram diagram, TextSizes sizes) {
    this.diagram = diagram;
    this.sizes = sizes;
  }

  /**
   * Renders a diagram.
   *
   * @param sizes the text sizes of the layout
   */
  public static String of(ChainDiagram diagram, TextSizes sizes) {
    return new DiagramSvg(diagram, sizes).write();
  }

  private String write() {
    out.append("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n")
        .append(
            String.format(
                Locale.ROOT,
                "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"%d\" height=\"%d\" viewBox=\"0 0"
                    + " %1$d %2$d\" font-family=\"Arial, Helvetica, sans-serif\">\n",
                diagram.width(),
                diagram.height()))
        .append("  <title>")
        .append(escape(diagram.name()))
        .append("</title>\n  <rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n");
    diagram.lines().forEach(this::line);
    diagram.boxes().forEach(this::box);
    return out.append("</svg>\n").toString();
  }

  private void line(Line line) {
    List<Point> points = line.points();
    boolean dashed = line.kind() == LineKind.NEXT_STEP || line.isBack();
    out.append("  <path d=\"%s\" fill=\"none\" stroke=\"%s\"".formatted(path(points), LINE))
        .append(dashed ? " stroke-dasharray=\"5 3\"/>\n" : "/>\n");
    Point end = points.get(points.size() - 1);
    int back = end.y() > points.get(points.size() - 2).y() ? -8 : 8;
    out.append(
        String.format(
            Locale.ROOT,
            "  <path d=\"M%d %d l-4 %d h8 z\" fill=\"%s\"/>\n",
            end.x(),
            end.y(),
            back,
            LINE));
  }

  /** Returns the commands that draw a way, with curves between columns. */
  private static String path(List<Point> points) {
    StringBuilder path = new StringBuilder("M" + at(points.get(0)));
    for (int i = 1; i < points.size(); i++) {
      Point from = points.get(i - 1);
      Point to = points.get(i);
      int middle = (from.y() + to.y()) / 2;
      path.append(
          from.x() == to.x()
              ? " L" + at(to)
              : " C%s %s %s".formatted(at(from.x(), middle), at(to.x(), middle), at(to)));
    }
    return path.toString();
  }

  private static String at(Point point) {
    return at(point.x(), point.y());
  }

  private static String at(int x, int y) {
    return x + " " + y;
  }

  private void box(Box box) {
    String fill =
        box.generated() ? "#e1edfb" : box.kind() == Kind.COMPONENT ? "#f1f3f5" : "#ffffff";
    String stroke = box.generated() ? "#0a58a8" : "#5b6770";
    out.append("  <g><title>%s</title>".formatted(escape(title(box))));
    if (box.kind() == Kind.COMPONENT) {
      rectangle(box.area(), 10, fill, stroke);
    } else {
      StringBuilder corners = new StringBuilder();
      Shapes.outline(box).forEach(p -> corners.append(p.x()).append(',').append(p.y()).append(' '));
      out.append(
          "<polygon points=\"%s\" fill=\"%s\" stroke=\"#9aa4ac\"/>"
              .formatted(corners.toString().strip(), fill));
    }
    box.bars().forEach(bar -> rectangle(bar, 0, LINE, LINE));
    for (Shapes.Stem stem : Shapes.stems(box)) {
      out.append(
          String.format(
              Locale.ROOT,
              "<path d=\"M%d %d V%d\" stroke=\"%s\"/>",
              stem.x(),
              stem.from(),
              stem.to(),
              LINE));
    }
    Shapes.texts(box, sizes).forEach(this::text);
    out.append("</g>\n");
  }

  private static String title(Box box) {
    return box.facts().isEmpty() ? box.name() : box.name() + " (" + box.facts() + ")";
  }

  private void rectangle(Area area, int radius, String fill, String stroke) {
    out.append(
        String.format(
            Locale.ROOT,
            "<rect x=\"%d\" y=\"%d\" width=\"%d\" height=\"%d\" rx=\"%d\" fill=\"%s\" stroke=\"%s\"/>",
            area.x(),
            area.y(),
            area.width(),
            area.height(),
            radius,
            fill,
            stroke));
  }

  /** Adds a text; any font is scaled to the width in the layout. */
  private void text(Shapes.PlacedText placed) {
    Text text = placed.text();
    int height = sizes.height(text.title());
    out.append(
        String.format(
            Locale.ROOT,
            "<text x=\"%d\" y=\"%d\" font-size=\"%d\" textLength=\"%d\""
                + " lengthAdjust=\"spacingAndGlyphs\"%s>%s</text>",
            placed.x(),
            placed.y() + Shapes.fontSize(height),
            Shapes.fontSize(height),
            Math.max(1, text.width()),
            text.title() ? " font-weight=\"bold\"" : "",
            escape(text.text())));
  }

  private static String escape(String text) {
    return INVISIBLE
        .matcher(Printable.clean(text))
        .replaceAll("\uFFFD")
        .replace("&", "&amp;")
        .replace("<", "&lt;")
        .replace(">", "&gt;");
  }
}
