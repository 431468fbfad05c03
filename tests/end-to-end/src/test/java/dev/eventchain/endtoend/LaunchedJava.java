package dev.eventchain.endtoend;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;

/** Java as the launcher starts it, with the launcher's archive of classes. */
final class LaunchedJava {

  static final Path JAVA = Path.of(System.getProperty("java.home"), "bin", "java");

  /** Options before the class path; the archive is made on first use, which takes some seconds. */
  static final List<String> OPTIONS = options();

  private LaunchedJava() {}

  private static List<String> options() {
    List<String> options =
        new ArrayList<>(
            List.of(
                "-XX:+UseSerialGC",
                "-XX:MaxNewSize=24m",
                "-XX:MinHeapFreeRatio=10",
                "-XX:MaxHeapFreeRatio=20",
                "-XX:TieredStopAtLevel=1",
                "-Xshare:auto",
                "-Xlog:disable"));
    Path application = Program.ROOT.resolve("bundles/front/cli/target/eventchain");
    launch(application);
    try (Stream<Path> files = Files.list(application)) {
      files
          .filter(file -> file.toString().endsWith(".jsa") && file.toFile().length() > 0)
          .forEach(file -> options.add("-XX:SharedArchiveFile=" + file));
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
    return List.copyOf(options);
  }

  /** Starts the program by the launcher's script, but never builds it: its jars are in use. */
  private static void launch(Path application) {
    String start = Program.ROOT.resolve("bundles/front/cli/src/main/shell/start").toString();
    String script = ". \"$start\"; find_java 'a JDK'; start --version";
    ProcessBuilder builder = new ProcessBuilder("bash", "-c", script);
    Map<String, String> environment = builder.environment();
    environment.put("start", start);
    environment.put("home", Program.ROOT.toString());
    environment.put("identity", Program.ROOT.toString());
    environment.put("library", application.resolve("lib").toString());
    environment.put("state", application.toString());
    environment.put("built", application.resolve("built").toString());
    environment.put("JAVA_HOME", System.getProperty("java.home"));
    builder.redirectOutput(ProcessBuilder.Redirect.DISCARD);
    try {
      int code =
          builder
              .redirectError(ProcessBuilder.Redirect.INHERIT)
              .start()
              .onExit()
              .join()
              .exitValue();
      if (code != 0) {
        throw new IllegalStateException("The launcher ends with exit code " + code + ".");
      }
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
