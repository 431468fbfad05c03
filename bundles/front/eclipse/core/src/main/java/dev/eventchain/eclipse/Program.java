package dev.eventchain.eclipse;

import java.io.File;
import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import org.eclipse.core.runtime.CoreException;
import org.eclipse.core.runtime.IProgressMonitor;
import org.eclipse.core.runtime.OperationCanceledException;

/**
 * The program {@code eventchain} as its own process: what runs Python, asks language models and
 * simulates stays out of the workbench.
 *
 * @param file the launcher
 */
public record Program(Path file) {

  /** How long a cancelled run may take to leave its files complete before it is killed. */
  private static final int SECONDS_TO_END = 10;

  private static final int MILLISECONDS_BETWEEN_LOOKS = 100;
  private static final int MILLISECONDS_TO_READ = 1000;

  /**
   * Finds the program: as people have set it, else on the path.
   *
   * @throws CoreException saying what to do if there is none
   */
  public static Program find() throws CoreException {
    String set = Preferences.program();
    Optional<Path> found =
        set.isEmpty()
            ? onPath()
            : Optional.of(Path.of(set)).filter(Path::isAbsolute).filter(Files::isExecutable);
    if (found.isPresent() && !Files.isDirectory(found.get())) {
      return new Program(found.get().toAbsolutePath());
    }
    String problem =
        set.isEmpty()
            ? "There is no program 'eventchain' on the PATH."
            : "'" + set + "' is not a program that can be started.";
    throw new CoreException(
        EventchainCore.failure(problem + " Set it under Window > Preferences > Eventchain.", null));
  }

  private static Optional<Path> onPath() {
    String path = System.getenv("PATH");
    return Arrays.stream(path == null ? new String[0] : path.split(File.pathSeparator))
        .filter(folder -> folder.startsWith(File.separator)) // "." would be another one elsewhere
        .map(folder -> Path.of(folder, "eventchain"))
        .filter(file -> Files.isRegularFile(file) && Files.isExecutable(file))
        .findFirst();
  }

  /**
   * Runs a command to its end.
   *
   * @param arguments the command and its arguments
   * @param folder where it runs
   * @param output is given what it prints, in pieces, from threads of its own
   * @param monitor a cancelled run is asked to end, and gets ten seconds for it
   * @return the exit code
   * @throws CoreException if it cannot be started
   * @throws OperationCanceledException if people cancelled it
   */
  public int run(
      List<String> arguments, Path folder, Consumer<String> output, IProgressMonitor monitor)
      throws CoreException {
    List<String> command = new ArrayList<>(List.of(file.toString()));
    command.addAll(arguments);
    Process process = start(command, folder);
    // If the workbench is ended from outside, nothing is left that could end the run.
    Thread end = new Thread(process::destroy);
    Runtime.getRuntime().addShutdownHook(end);
    try {
      return await(process, output, monitor);
    } finally {
      forget(end);
    }
  }

  private static void forget(Thread hook) {
    try {
      Runtime.getRuntime().removeShutdownHook(hook);
    } catch (IllegalStateException e) {
      return; // it is being run
    }
  }

  private static int await(Process process, Consumer<String> output, IProgressMonitor monitor) {
    Thread reader = new Thread(() -> read(process.getInputStream(), output), "eventchain output");
    reader.setDaemon(true);
    reader.start();
    try {
      while (!process.waitFor(MILLISECONDS_BETWEEN_LOOKS, TimeUnit.MILLISECONDS)) {
        if (monitor.isCanceled()) {
          end(process);
          reader.join(MILLISECONDS_TO_READ); // what it said last
          throw new OperationCanceledException();
        }
      }
      while (reader.isAlive()) { // as long as a helper that it left behind may write
        reader.join(MILLISECONDS_BETWEEN_LOOKS);
        if (monitor.isCanceled()) {
          throw new OperationCanceledException();
        }
      }
      return process.exitValue();
    } catch (InterruptedException e) {
      process.destroyForcibly();
      Thread.currentThread().interrupt();
      throw new OperationCanceledException();
    }
  }

  private static Process start(List<String> command, Path folder) throws CoreException {
    try {
      ProcessBuilder builder = new ProcessBuilder(command);
      builder.directory(folder.toFile()).redirectErrorStream(true);
      builder.environment().put("NO_COLOR", "1");
      Process process = builder.start();
      process.getOutputStream().close(); // nobody is there to answer
      return process;
    } catch (IOException e) {
      throw new CoreException(
          EventchainCore.failure("The program cannot be started: " + e.getMessage(), e));
    }
  }

  /** SIGTERM leaves every file as it was or complete. */
  private static void end(Process process) throws InterruptedException {
    process.destroy();
    if (!process.waitFor(SECONDS_TO_END, TimeUnit.SECONDS)) {
      process.destroyForcibly();
    }
  }

  private static void read(InputStream stream, Consumer<String> output) {
    try (InputStreamReader text = new InputStreamReader(stream, StandardCharsets.UTF_8)) {
      char[] buffer = new char[4096];
      for (int count = text.read(buffer); count >= 0; count = text.read(buffer)) {
        output.accept(new String(buffer, 0, count));
      }
    } catch (IOException e) {
      output.accept("\n(its output ended: " + e.getMessage() + ")\n");
    }
  }
}
