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
 * The program {@code eventchain} in a separate process, so that Python, language models and
 * simulations do not run in the workbench.
 *
 * @param file the launcher
 */
public record Program(Path file) {

  /** Time in seconds that a cancelled run has to complete its files before it is killed. */
  private static final int SECONDS_TO_END = 10;

  private static final int MILLISECONDS_BETWEEN_LOOKS = 100;
  private static final int MILLISECONDS_TO_READ = 1000;

  /**
   * Finds the program: the configured one, else that on the search path.
   *
   * @throws CoreException with a hint if there is none
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
        .filter(
            folder -> folder.startsWith(File.separator)) // "." would mean another folder elsewhere
        .map(folder -> Path.of(folder, "eventchain"))
        .filter(file -> Files.isRegularFile(file) && Files.isExecutable(file))
        .findFirst();
  }

  /**
   * Runs a command to its end.
   *
   * @param arguments the command and its arguments
   * @param folder its working folder
   * @param output receives its output in pieces, on separate threads
   * @param monitor its cancellation asks the run to end within ten seconds
   * @return the exit code
   * @throws CoreException if it cannot be started
   * @throws OperationCanceledException if it was cancelled
   */
  public int run(
      List<String> arguments, Path folder, Consumer<String> output, IProgressMonitor monitor)
      throws CoreException {
    List<String> command = new ArrayList<>(List.of(file.toString()));
    command.addAll(arguments);
    Process process = start(command, folder);
    // If the workbench is killed, nothing else can end the run.
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
      return; // the process is being run
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
          reader.join(MILLISECONDS_TO_READ); // its last output
          throw new OperationCanceledException();
        }
      }
      while (reader.isAlive()) { // while a helper process may still write
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
      process.getOutputStream().close(); // prompts cannot be answered
      return process;
    } catch (IOException e) {
      throw new CoreException(
          EventchainCore.failure("The program cannot be started: " + e.getMessage(), e));
    }
  }

  /** Ends a process by SIGTERM, which leaves every file unchanged or complete. */
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
