package dev.eventchain.pipeline.diagram;

import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import dev.eventchain.model.diagram.ChainDiagram;
import dev.eventchain.model.diagram.ChainDiagram.Area;
import dev.eventchain.model.diagram.ChainDiagram.Box;
import dev.eventchain.model.diagram.ChainDiagram.Kind;
import dev.eventchain.model.diagram.ChainDiagram.Line;
import dev.eventchain.model.diagram.ChainDiagram.LineKind;
import dev.eventchain.model.diagram.ChainDiagram.Point;
import dev.eventchain.model.diagram.ChainLayout;
import dev.eventchain.model.diagram.PrintedSizes;
import dev.eventchain.model.diagram.Shapes;
import dev.eventchain.model.eventchain.Data;
import dev.eventchain.model.eventchain.EventChain;

/** A chain as a picture in JSON: where its boxes, texts and lines are, in pixels. */
public final class ChainPicture {

  private static final PrintedSizes SIZES = new PrintedSizes();

  private ChainPicture() {}

  public static ObjectNode of(EventChain chain) {
    ChainDiagram diagram = ChainLayout.of(chain, SIZES);
    ObjectNode picture = JsonNodeFactory.instance.objectNode();
    picture.put("name", diagram.name());
    picture.put("width", diagram.width()).put("height", diagram.height());
    ArrayNode boxes = picture.putArray("boxes");
    diagram.boxes().forEach(box -> boxes.add(box(box)));
    ArrayNode lines = picture.putArray("lines");
    diagram.lines().forEach(line -> lines.add(line(line)));
    return picture;
  }

  private static ObjectNode box(Box box) {
    ObjectNode json = JsonNodeFactory.instance.objectNode();
    json.put("kind", box.kind().name()).put("name", box.name()).put("facts", box.facts());
    json.put("generated", box.generated());
    if (isExternal(box)) {
      json.put("external", true);
    }
    area(json, box.area());
    points(json.putArray("corners"), Shapes.outline(box));
    ArrayNode bars = json.putArray("bars");
    box.bars().forEach(bar -> area(bars.addObject(), bar));
    ArrayNode stems = json.putArray("stems");
    for (Shapes.Stem stem : Shapes.stems(box)) {
      stems.addObject().put("x", stem.x()).put("from", stem.from()).put("to", stem.to());
    }
    ArrayNode texts = json.putArray("texts");
    for (Shapes.PlacedText placed : Shapes.texts(box, SIZES)) {
      boolean title = placed.text().title();
      texts
          .addObject()
          .put("text", placed.text().text())
          .put("x", placed.x())
          .put("y", placed.y() + Shapes.fontSize(SIZES.height(title)))
          .put("width", placed.text().width())
          .put("size", Shapes.fontSize(SIZES.height(title)))
          .put("title", title);
    }
    return json;
  }

  /** Returns whether a signal leaves the chain because the model declares that. */
  private static boolean isExternal(Box box) {
    return box.kind() == Kind.SIGNAL_OUT
        && box.elements().stream()
            .anyMatch(element -> element instanceof Data data && data.isExternal());
  }

  private static ObjectNode line(Line line) {
    ObjectNode json = JsonNodeFactory.instance.objectNode();
    json.put("from", line.from()).put("to", line.to());
    json.put("dashed", line.isBack() || line.kind() == LineKind.NEXT_STEP);
    points(json.putArray("points"), line.points());
    return json;
  }

  private static void area(ObjectNode json, Area area) {
    json.put("x", area.x()).put("y", area.y());
    json.put("width", area.width()).put("height", area.height());
  }

  private static void points(ArrayNode json, Iterable<Point> points) {
    points.forEach(point -> json.addArray().add(point.x()).add(point.y()));
  }
}
