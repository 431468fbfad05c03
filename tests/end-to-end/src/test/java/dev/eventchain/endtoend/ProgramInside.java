package dev.eventchain.endtoend;

import java.io.File;
import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.io.UncheckedIOException;
import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Method;
import java.net.MalformedURLException;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.FutureTask;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/**
 * The program in the process of the tests. Its classes come from the launcher's jars, not from the
 * tests' class path, and are loaded once for all tests; as in a separate process, each command is a
 * thread's only work.
 */
final class ProgramInside {

  static final String MAIN = "dev.eventchain.cli.Main";

  /** All jars in a fixed order, so that all processes have the same class path. */
  static final String CLASS_PATH =
      jars().stream().map(Path::toString).collect(Collectors.joining(File.pathSeparator));

  private static final ClassLoader LOADER = loader();

  private ProgramInside() {}

  private static List<Path> jars() {
    Path library = Program.ROOT.resolve("bundles/front/cli/target/eventchain/lib");
    try (Stream<Path> files = Files.list(library)) {
      return files.filter(file -> file.toString().endsWith(".jar")).sorted().toList();
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private static ClassLoader loader() {
    // A run's results belong to the build of the program, which is identified by its class path.
    System.setProperty("java.class.path", CLASS_PATH);
    URL[] urls = jars().stream().map(ProgramInside::url).toArray(URL[]::new);
    ClassLoader loader = new URLClassLoader(urls, ClassLoader.getPlatformClassLoader());
    loadMetamodels(loader);
    return loader;
  }

  /** A process has one command; here, several threads begin at once. */
  private static void loadMetamodels(ClassLoader loader) {
    Thread thread = Thread.currentThread();
    ClassLoader before = thread.getContextClassLoader();
    thread.setContextClassLoader(loader);
    try {
      loader.loadClass("dev.eventchain.check.ChainModel").getMethod("loadMetamodels").invoke(null);
    } catch (ReflectiveOperationException e) {
      throw new IllegalStateException(e);
    } finally {
      thread.setContextClassLoader(before);
    }
  }

  private static URL url(Path file) {
    try {
      return file.toUri().toURL();
    } catch (MalformedURLException e) {
      throw new IllegalStateException(e);
    }
  }

  /** Runs a command to its end. */
  static Program.Ended run(List<String> arguments) {
    StringWriter out = new StringWriter();
    StringWriter err = new StringWriter();
    FutureTask<Integer> command = new FutureTask<>(() -> call(arguments, out, err));
    Thread thread = new Thread(command, "main");
    thread.setContextClassLoader(LOADER);
    thread.setDaemon(true);
    thread.start();
    try {
      int code = command.get(Program.LONGEST_SECONDS, TimeUnit.SECONDS);
      return new Program.Ended(code, out.toString(), err.toString());
    } catch (TimeoutException e) {
      throw new AssertionError("still running: " + err, e);
    } catch (ExecutionException e) {
      throw new AssertionError(arguments + " ended with an exception\n" + err, e.getCause());
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new IllegalStateException(e);
    }
  }

  /** Calls {@code Main.run}: the program without its process. */
  private static int call(List<String> arguments, StringWriter out, StringWriter err)
      throws ReflectiveOperationException {
    Class<?> terminal = LOADER.loadClass("dev.eventchain.cli.console.Terminal");
    Method of = terminal.getDeclaredMethod("of", Map.class);
    Method run =
        LOADER
            .loadClass(MAIN)
            .getDeclaredMethod(
                "run", String[].class, PrintWriter.class, PrintWriter.class, terminal);
    of.setAccessible(true);
    run.setAccessible(true);
    try (PrintWriter results = new PrintWriter(out);
        PrintWriter progress = new PrintWriter(err)) {
      String[] words = arguments.toArray(String[]::new);
      return (int) run.invoke(null, words, results, progress, of.invoke(null, System.getenv()));
    } catch (InvocationTargetException e) {
      throw new AssertionError("the command threw what the program catches", e.getCause());
    }
  }
}
