package dev.eventchain.eclipse.ui.editor.model;

import dev.eventchain.model.eventchain.ComponentOrigin;
import dev.eventchain.model.eventchain.Data;
import dev.eventchain.model.eventchain.EventChain;
import dev.eventchain.model.eventchain.LatencyConstraint;
import dev.eventchain.model.eventchain.Processor;
import dev.eventchain.model.eventchain.QosProfile;
import dev.eventchain.model.eventchain.Requirement;
import dev.eventchain.model.eventchain.SoftwareNode;
import java.awt.BasicStroke;
import java.awt.Shape;
import java.awt.geom.Area;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Path2D;
import java.awt.geom.Rectangle2D;
import java.awt.geom.RoundRectangle2D;
import org.eclipse.jface.resource.ImageDescriptor;
import org.eclipse.swt.graphics.ImageData;
import org.eclipse.swt.graphics.PaletteData;

/** Icons of the elements, drawn for every resolution from shapes of 16 by 16. */
public enum Icon {
  CHAIN(0x2F5D8C, chain()),
  EXISTING(0x1F4E79, new RoundRectangle2D.Double(1, 3, 14, 10, 4, 4)),
  GENERATED(0x1F4E79, line(1.8f, new RoundRectangle2D.Double(2, 4, 12, 8, 4, 4))),
  INPUT(0x2E8B57, arrow(1)),
  OUTPUT(0xC8731C, arrow(5)),
  DATA(0x808890, new Ellipse2D.Double(5, 5, 6, 6)),
  QOS(0x7A5BA8, bars(11, 7, 9)),
  REQUIREMENT(0x8A6D3B, page()),
  LATENCY(0xB23A48, clock()),
  PROCESSOR(0x5A6B3B, chip()),
  MEASURED(0x46808A, bars(5, 8, 12)),
  GROUP(0xC9A227, folder()),
  UP(0x4A5560, triangle(11, 4)),
  DOWN(0x4A5560, triangle(5, 12));

  private static final int SIZE = 16;

  /** Samples per pixel in each direction. */
  private static final int SAMPLES = 4;

  private final int color;
  private final Shape shape;

  /** Descriptor of the icon: equal descriptors share an image. */
  private final ImageDescriptor descriptor =
      ImageDescriptor.createFromImageDataProvider(this::draw);

  Icon(int color, Shape shape) {
    this.color = color;
    this.shape = shape;
  }

  /** Returns the icon of an element of the tree, which for data depends on its users. */
  public static Icon of(Object element) {
    if (element instanceof Group) {
      return GROUP;
    } else if (element instanceof EventChain) {
      return CHAIN;
    } else if (element instanceof SoftwareNode node) {
      return node.getOrigin() == ComponentOrigin.GENERATED ? GENERATED : EXISTING;
    } else if (element instanceof Data data) {
      return ofData(data);
    } else if (element instanceof QosProfile) {
      return QOS;
    } else if (element instanceof Requirement) {
      return REQUIREMENT;
    } else if (element instanceof Processor) {
      return PROCESSOR;
    }
    return element instanceof LatencyConstraint ? LATENCY : MEASURED;
  }

  private static Icon ofData(Data data) {
    if (!(TreeContent.parent(data) instanceof SoftwareNode node)) {
      return DATA;
    }
    return node.getInput().contains(data) ? INPUT : OUTPUT;
  }

  /** Returns the icon, for a registry or a menu. */
  public ImageDescriptor descriptor() {
    return descriptor;
  }

  private ImageData draw(int zoom) {
    int size = SIZE * zoom / 100;
    double step = (double) SIZE / (size * SAMPLES);
    ImageData data = new ImageData(size, size, 24, new PaletteData(0xFF0000, 0xFF00, 0xFF));
    for (int y = 0; y < size; y++) {
      for (int x = 0; x < size; x++) {
        int inside = 0;
        for (int i = 0; i < SAMPLES * SAMPLES; i++) {
          double px = (x * SAMPLES + i % SAMPLES + 0.5) * step;
          double py = (y * SAMPLES + i / SAMPLES + 0.5) * step;
          inside += shape.contains(px, py) ? 1 : 0;
        }
        data.setPixel(x, y, color);
        data.setAlpha(x, y, 255 * inside / (SAMPLES * SAMPLES));
      }
    }
    return data;
  }

  private static Shape line(float width, Shape shape) {
    return new BasicStroke(width, BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND)
        .createStrokedShape(shape);
  }

  private static Shape chain() {
    Area area = new Area(new Ellipse2D.Double(0.5, 5.5, 5, 5));
    area.add(new Area(new Ellipse2D.Double(10.5, 5.5, 5, 5)));
    area.add(new Area(new Rectangle2D.Double(5, 7, 6, 2)));
    return area;
  }

  /** Returns an arrow to the right with its target or source side. */
  private static Shape arrow(double start) {
    Path2D path = new Path2D.Double();
    path.moveTo(start, 6.5);
    path.lineTo(start + 5, 6.5);
    path.lineTo(start + 5, 3.5);
    path.lineTo(start + 10, 8);
    path.lineTo(start + 5, 12.5);
    path.lineTo(start + 5, 9.5);
    path.lineTo(start, 9.5);
    path.closePath();
    Area area = new Area(path);
    area.add(new Area(new Rectangle2D.Double(start < 3 ? 12 : 2, 2, 2, 12)));
    return area;
  }

  private static Shape bars(int first, int second, int third) {
    Area area = new Area(new Rectangle2D.Double(2, 14 - first, 3, first));
    area.add(new Area(new Rectangle2D.Double(6.5, 14 - second, 3, second)));
    area.add(new Area(new Rectangle2D.Double(11, 14 - third, 3, third)));
    return area;
  }

  /** Returns a square with pins on all sides. */
  private static Shape chip() {
    Area area = new Area(new Rectangle2D.Double(4, 4, 8, 8));
    for (int pin = 5; pin < 12; pin += 2) {
      area.add(new Area(new Rectangle2D.Double(pin, 1, 1, 14)));
      area.add(new Area(new Rectangle2D.Double(1, pin, 14, 1)));
    }
    return area;
  }

  private static Shape page() {
    Area area = new Area(new RoundRectangle2D.Double(3, 1, 10, 14, 2, 2));
    for (int y = 4; y < 12; y += 3) {
      area.subtract(new Area(new Rectangle2D.Double(5, y, 6, 1.2)));
    }
    return area;
  }

  private static Shape clock() {
    Path2D hands = new Path2D.Double();
    hands.moveTo(8, 4.5);
    hands.lineTo(8, 8);
    hands.lineTo(10.5, 9.5);
    Area area = new Area(line(1.6f, new Ellipse2D.Double(2, 2, 12, 12)));
    area.add(new Area(line(1.4f, hands)));
    return area;
  }

  private static Shape triangle(double base, double tip) {
    Path2D path = new Path2D.Double();
    path.moveTo(3, base);
    path.lineTo(13, base);
    path.lineTo(8, tip);
    path.closePath();
    return path;
  }

  private static Shape folder() {
    Area area = new Area(new RoundRectangle2D.Double(1, 4.5, 14, 9, 2, 2));
    area.add(new Area(new RoundRectangle2D.Double(1, 2.5, 6, 5, 2, 2)));
    return area;
  }
}
