package dev.eventchain.eclipse.ui.diagram;

import dev.eventchain.model.diagram.ChainDiagram;
import dev.eventchain.model.diagram.DiagramSvg;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import org.eclipse.swt.SWT;
import org.eclipse.swt.graphics.GC;
import org.eclipse.swt.graphics.Image;
import org.eclipse.swt.graphics.ImageData;
import org.eclipse.swt.graphics.ImageLoader;
import org.eclipse.swt.graphics.Rectangle;
import org.eclipse.swt.graphics.Transform;
import org.eclipse.swt.widgets.Display;

/** Writes the diagram for documents, on white. For the user interface's thread. */
final class PictureWriter {

  /** Largest number of pixels: they take 160 MB during drawing. */
  private static final double MOST_PIXELS = 40e6;

  private static final double SHARP = 2;

  private PictureWriter() {}

  /** Writes a file: SVG if its name ends in .svg, else PNG. */
  static void write(ChainDiagram diagram, Display display, Path file) throws IOException {
    boolean isSvg = file.getFileName().toString().toLowerCase(Locale.ROOT).endsWith(".svg");
    Files.write(file, isSvg ? svg(diagram, display) : png(diagram, display));
  }

  private static byte[] svg(ChainDiagram diagram, Display display) {
    try (DiagramFonts fonts = new DiagramFonts(display)) {
      return DiagramSvg.of(diagram, fonts).getBytes(StandardCharsets.UTF_8);
    }
  }

  private static byte[] png(ChainDiagram diagram, Display display) {
    ImageLoader loader = new ImageLoader();
    loader.data = new ImageData[] {image(diagram, display)};
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    loader.save(bytes, SWT.IMAGE_PNG);
    return bytes.toByteArray();
  }

  /** Returns the diagram at twice its size, or less if it is very large. */
  static ImageData image(ChainDiagram diagram, Display display) {
    double area = Math.max(1.0, diagram.width()) * Math.max(1.0, diagram.height());
    double scale = Math.min(SHARP, Math.sqrt(MOST_PIXELS / area));
    int width = Math.max(1, (int) (diagram.width() * scale));
    int height = Math.max(1, (int) (diagram.height() * scale));
    Image image = new Image(display, width, height);
    GC gc = new GC(image);
    Transform transform = new Transform(display);
    DiagramColors colors = DiagramColors.ofPaper(display);
    try (DiagramFonts fonts = new DiagramFonts(display)) {
      gc.setBackground(colors.background());
      gc.fillRectangle(0, 0, width, height);
      transform.scale((float) scale, (float) scale);
      gc.setTransform(transform);
      Rectangle all = new Rectangle(0, 0, diagram.width(), diagram.height());
      new DiagramPainter(gc, colors, fonts).paint(diagram, List.of(), -1, all);
      return image.getImageData(100);
    } finally {
      transform.dispose();
      gc.dispose();
      image.dispose();
    }
  }
}
