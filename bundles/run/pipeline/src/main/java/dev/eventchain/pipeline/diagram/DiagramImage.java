package dev.eventchain.pipeline.diagram;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.io.PrintStream;
import java.io.UncheckedIOException;
import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.nio.charset.Charset;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.Optional;
import java.util.regex.Pattern;
import net.sourceforge.plantuml.FileFormat;
import net.sourceforge.plantuml.FileFormatOption;
import net.sourceforge.plantuml.SourceStringReader;
import net.sourceforge.plantuml.core.Diagram;
import net.sourceforge.plantuml.core.ImageData;
import net.sourceforge.plantuml.error.PSystemError;

/**
 * Renders PlantUML text as SVG with the PlantUML library in this process: without Graphviz, local
 * fonts, files or network. The same text gives the same bytes everywhere. Only this class uses the
 * library, so that only drawing commands load it.
 */
final class DiagramImage {

  /** Stack size: the layout recurses along the longest path of the graph. */
  private static final long STACK_BYTES = 256L << 20;

  /** Wall time per second of processor time, for busy machines. */
  private static final int WALL_FACTOR = 60;

  /** The library writes its version into each picture. */
  private static final Pattern VERSION = Pattern.compile("<\\?plantuml [^?]*\\?>");

  static {
    System.setProperty("java.awt.headless", "true");
    // No access to files or addresses, whatever the text contains. The library reads this once.
    System.setProperty("PLANTUML_SECURITY_PROFILE", "SANDBOX");
  }

  /** Failure of PlantUML, which fails for some models and says nothing about them. */
  static final class UndrawableException extends RuntimeException {
    private static final long serialVersionUID = 1L;

    private UndrawableException(Throwable cause) {
      super(cause);
    }
  }

  private DiagramImage() {}

  /**
   * Renders PlantUML text.
   *
   * @param text the output of a template of templates/plantuml
   * @param longest the processor time that it may take
   * @return empty on timeout; the library cannot be stopped and continues in a daemon thread
   * @throws UndrawableException if the library cannot draw it
   */
  static Optional<byte[]> svg(String text, Duration longest) {
    String[] svg = new String[1];
    Throwable[] failure = new Throwable[1];
    Thread drawing = new Thread(null, () -> svg[0] = draw(text), "diagram", STACK_BYTES);
    drawing.setDaemon(true);
    drawing.setUncaughtExceptionHandler((thread, thrown) -> failure[0] = thrown);
    PrintStream before = System.err;
    System.setErr(withoutThread(before, drawing)); // PlantUML prints its failures
    drawing.start();
    try {
      await(drawing, longest);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new IllegalStateException("The drawing was interrupted", e);
    } finally {
      System.setErr(before);
    }
    if (failure[0] != null) {
      throw new UndrawableException(failure[0]);
    }
    if (drawing.isAlive()) {
      return Optional.empty();
    }
    String picture = VERSION.matcher(svg[0]).replaceAll("");
    return Optional.of(picture.getBytes(StandardCharsets.UTF_8));
  }

  /** Returns a stream that swallows what one thread prints. */
  private static PrintStream withoutThread(PrintStream stream, Thread swallowed) {
    OutputStream filter =
        new OutputStream() {
          @Override
          public void write(int b) {
            if (Thread.currentThread() != swallowed) {
              stream.write(b);
            }
          }

          @Override
          public void write(byte[] bytes, int offset, int length) {
            if (Thread.currentThread() != swallowed) {
              stream.write(bytes, offset, length);
            }
          }

          @Override
          public void flush() {
            stream.flush();
          }
        };
    return new PrintStream(filter, true, Charset.defaultCharset());
  }

  /** Waits until a thread has ended or used a processor time, with a limit. */
  private static void await(Thread thread, Duration longest) throws InterruptedException {
    ThreadMXBean threads = ManagementFactory.getThreadMXBean();
    boolean measurable = threads.isThreadCpuTimeSupported() && threads.isThreadCpuTimeEnabled();
    long end = System.nanoTime() + WALL_FACTOR * longest.toNanos();
    Duration left = longest;
    while (thread.isAlive() && left.compareTo(Duration.ZERO) > 0 && System.nanoTime() < end) {
      // It cannot use more processor time than elapses.
      thread.join(left.toMillis() + 1);
      long used = measurable ? threads.getThreadCpuTime(thread.getId()) : longest.toNanos();
      left = longest.minusNanos(used);
    }
  }

  private static String draw(String text) {
    Diagram diagram = new SourceStringReader(text).getBlocks().get(0).getDiagram();
    if (diagram instanceof PSystemError error) {
      throw new IllegalStateException(error.getDescription() + "\n" + text);
    }
    ByteArrayOutputStream svg = new ByteArrayOutputStream();
    try {
      FileFormatOption option = new FileFormatOption(FileFormat.SVG_DETERMINISTIC, false);
      ImageData image = diagram.exportDiagram(svg, 0, option);
      if (image.getStatus() != 0) {
        throw new IllegalStateException("status " + image.getStatus());
      }
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
    return svg.toString(StandardCharsets.UTF_8);
  }
}
