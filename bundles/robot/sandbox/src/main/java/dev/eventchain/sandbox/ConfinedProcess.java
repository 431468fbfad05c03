package dev.eventchain.sandbox;

import com.fasterxml.jackson.databind.JsonNode;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import java.io.Closeable;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicReference;
import java.util.stream.Stream;

/**
 * A Python process that runs an untrusted program.
 *
 * <p>It can read Python itself, the system's libraries and the given paths, and write only its work
 * folder. It has no network except sockets made by {@link Builder#preparation}, and cannot start
 * processes. It ends when it exceeds its limits, when it is closed, or when this JVM ends. Its only
 * environment variables make it reproducible ({@code PYTHONHASHSEED}, UTF-8, no byte code files);
 * home and temporary folder are the work folder. See {@link Confinement} for the mechanisms.
 *
 * <p>The caller has to read standard output; otherwise the process blocks until its time limit.
 * Standard error is always read, and its first and last parts are kept; a process that writes more
 * than 16 MiB there is killed.
 */
public final class ConfinedProcess implements AutoCloseable {

  /**
   * Resource limits of the process.
   *
   * @param wallTime time from its start until it is killed
   * @param cpuTime processor time, whole seconds, rounded up
   * @param memoryMiB address space in MiB; Python with NumPy needs about 100
   */
  public record Limits(Duration wallTime, Duration cpuTime, int memoryMiB) {}

  /** Reasons for the end of a process. */
  public enum Cause {
    /** It ended by itself, or by a signal that it caused. */
    EXITED,
    /** It exceeded its wall time. */
    WALL_TIME,
    /** It exceeded its processor time. */
    CPU_TIME,
    /** It exceeded the limit of standard error. */
    OUTPUT,
    /** {@link ConfinedProcess#close} was called, or the waiting thread was interrupted. */
    CLOSED
  }

  /**
   * The termination of a process.
   *
   * @param exitCode its exit code; 128 plus the signal number if a signal ended it
   */
  public record Termination(Cause cause, int exitCode) {
    /** Returns whether the process ended by itself with exit code 0. */
    public boolean isSuccess() {
      return cause == Cause.EXITED && exitCode == 0;
    }
  }

  /**
   * The answer of a program to its only request.
   *
   * @param output its standard output as UTF-8
   * @param standardError as {@link ConfinedProcess#standardError}
   */
  public record Answer(String output, Termination end, String standardError) {}

  private static final int CPU_TIME_SIGNAL = 128 + 24;
  private static final long CLOSE_SECONDS = 5;
  private static final long MOST_OUTPUT = 16L * 1024 * 1024;

  private final Process process;
  private final StandardError standardError;
  private final AtomicReference<Cause> cause = new AtomicReference<>(Cause.EXITED);

  private ConfinedProcess(Process process, Duration wallTime) {
    this.process = process;
    this.standardError =
        StandardError.of(process.getErrorStream(), MOST_OUTPUT, () -> kill(Cause.OUTPUT));
    var kill = ProcessThreads.after(wallTime, () -> kill(Cause.WALL_TIME));
    var unused = process.onExit().thenRun(() -> kill.cancel(false));
  }

  /** Returns a builder for a process on this Python. */
  public static Builder on(PythonEnvironment environment) {
    return new Builder(environment);
  }

  /** Returns the stream to the program's standard input. */
  public OutputStream stdin() {
    return process.getOutputStream();
  }

  /** Returns the stream of the program's standard output. */
  public InputStream stdout() {
    return process.getInputStream();
  }

  /** Returns its standard error so far, shortened in the middle beyond 64 KiB. */
  public String standardError() {
    return standardError.text();
  }

  /** Returns the processor time used so far by it and its descendants that are still running. */
  public Duration processorTime() {
    return processes()
        .map(handle -> handle.info().totalCpuDuration().orElse(Duration.ZERO))
        .reduce(Duration.ZERO, Duration::plus);
  }

  /**
   * Returns whether it or a descendant is stopped by a signal such as SIGSTOP; false where that is
   * unknown.
   */
  public boolean isStopped() {
    return processes().anyMatch(handle -> ProcessState.of(handle.pid()).isStopped());
  }

  /** Returns whether it is a fork of a {@link Template}. */
  boolean isForked() {
    return process instanceof ForkedProcess;
  }

  /** Returns the process and its descendants. */
  Stream<ProcessHandle> processes() {
    return Stream.concat(Stream.of(process.toHandle()), process.descendants());
  }

  /** Returns whether it is still running. */
  public boolean isAlive() {
    return process.isAlive();
  }

  /**
   * Sends a program its only request, and waits for the answer and its end.
   *
   * @param mostOutput the number of bytes at which it is killed, so that it never ends well
   * @throws IOException if the answer cannot be read
   */
  public Answer ask(byte[] request, int mostOutput) throws IOException {
    try (OutputStream input = stdin()) {
      input.write(request);
    } catch (IOException e) {
      // The program ended before it read its input; its termination gives the reason.
    }
    byte[] output = stdout().readNBytes(mostOutput);
    boolean isCut = output.length == mostOutput;
    if (isCut) {
      kill(Cause.CLOSED);
    }
    Termination end = await();
    return new Answer(
        new String(output, StandardCharsets.UTF_8),
        isCut ? new Termination(Cause.CLOSED, end.exitCode()) : end,
        standardError());
  }

  /** Waits until it has ended and its standard error is complete. */
  public Termination await() {
    try {
      int exitCode = process.waitFor();
      standardError.await();
      boolean outOfTime = cause.get() == Cause.EXITED && exitCode == CPU_TIME_SIGNAL;
      return new Termination(outOfTime ? Cause.CPU_TIME : cause.get(), exitCode);
    } catch (InterruptedException e) {
      close();
      Thread.currentThread().interrupt();
      return new Termination(cause.get(), process.isAlive() ? -1 : process.exitValue());
    }
  }

  /**
   * Waits until it has ended, and kills it if it does not end by itself for a time: a process whose
   * output ends is about to, unless it has closed that.
   */
  public Termination awaitOrKill(Duration patience) {
    try {
      process.waitFor(patience.toNanos(), TimeUnit.NANOSECONDS);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt(); // which await() and close() heed
    }
    close();
    return await();
  }

  /** Kills it if it is still running. */
  @Override
  public void close() {
    if (process.isAlive()) {
      kill(Cause.CLOSED);
    }
    boolean interrupted = Thread.interrupted();
    try {
      process.waitFor(CLOSE_SECONDS, TimeUnit.SECONDS);
    } catch (InterruptedException e) {
      interrupted = true;
    }
    if (interrupted) {
      Thread.currentThread().interrupt();
    }
    closeQuietly(process.getOutputStream());
    closeQuietly(process.getInputStream());
  }

  private static void closeQuietly(Closeable stream) {
    try {
      stream.close();
    } catch (IOException e) {
      // Its other end is closed, so that nothing is lost.
    }
  }

  void kill(Cause why) {
    if (process.isAlive() && cause.compareAndSet(Cause.EXITED, why)) {
      process.descendants().forEach(ProcessHandle::destroyForcibly);
      process.destroyForcibly();
    }
  }

  /** Builder of a process. A program, a work folder and limits are required. */
  public static final class Builder {

    private final ConfinedCommand command;
    private Duration wallTime = Duration.ofSeconds(10);

    private Builder(PythonEnvironment environment) {
      this.command = new ConfinedCommand(environment);
      limits(new Limits(wallTime, wallTime, 512));
    }

    /**
     * Runs a script file. The script's folder is not on the module path: see {@link #pythonPath}.
     */
    public Builder script(Path script) {
      command.program("script", script.toAbsolutePath().toString());
      return readable(script);
    }

    /** Runs a module of the {@link #pythonPath}, as {@code python -m} does. */
    public Builder module(String name) {
      command.program("module", name);
      return this;
    }

    /**
     * Lets the program call components through {@code component_client.py}. Each component then
     * runs in its own process with these limits, and may write only its own folder in the work
     * folder.
     *
     * @param turn index among several such processes: each is pinned to one processor, ideally a
     *     different one
     * @param files those of the components that are known: what takes long to import, and is
     *     imported by one of them, is imported ahead
     */
    public Builder components(int turn, Path... files) {
      command.components(turn, List.of(files));
      return this;
    }

    /**
     * Calls {@code prepare} of a trusted module of the {@link #pythonPath} before the process is
     * confined. It creates resources that the program needs but may not create itself: sockets on
     * this machine's network, and threads for them.
     */
    public Builder preparation(String module, JsonNode settings) {
      command.preparation(module, settings);
      return this;
    }

    /**
     * Sets the seed of Python's hashes, which decides about the order of sets; the default is 0.
     */
    public Builder hashSeed(int seed) {
      command.hashSeed(seed);
      return this;
    }

    /** Sets the arguments of the program. */
    public Builder arguments(String... arguments) {
      command.arguments(List.of(arguments));
      return this;
    }

    /**
     * Sets the only folder that the program may write, also its current folder; it has to exist.
     */
    public Builder workFolder(Path folder) {
      command.workFolder(folder);
      return this;
    }

    /** Adds files and folders that the program may read besides Python and its packages. */
    public Builder readable(Path... paths) {
      command.readable(List.of(paths));
      return this;
    }

    /**
     * Adds folders of our own Python sources to the module path. They are readable and, if writable
     * for us, compiled ahead of time for a fast start.
     */
    public Builder pythonPath(Path... folders) {
      command.pythonPath(List.of(folders));
      return this;
    }

    /** Sets the limits; the default is ten seconds and 512 MiB. */
    public Builder limits(Limits limits) {
      wallTime = limits.wallTime();
      command.limits(limits);
      return this;
    }

    /** Sets the confinement; the default is {@link Confinement#detect}. */
    public Builder confinement(Confinement confinement) {
      command.confinement(confinement);
      return this;
    }

    /** Starts a new interpreter in any case, for tests and comparisons. */
    Builder withoutTemplate() {
      command.withoutTemplate();
      return this;
    }

    /** Disables the kernel's layer, for tests of the other layers. */
    Builder withoutKernel() {
      command.withoutKernel();
      return this;
    }

    /** Disables the audit hooks, for tests of the other layers. */
    Builder withoutHooks() {
      command.withoutHooks();
      return this;
    }

    /**
     * Starts the process.
     *
     * @throws DiagnosticException {@code python.unavailable}: the process cannot be started
     */
    public ConfinedProcess start() {
      command.compile();
      Optional<Process> forked = command.template().flatMap(it -> Template.start(it, command));
      return new ConfinedProcess(forked.orElseGet(this::startInterpreter), wallTime);
    }

    private Process startInterpreter() {
      List<String> line = command.line();
      ProcessBuilder builder = new ProcessBuilder(line);
      builder.environment().clear();
      builder.environment().putAll(command.settings());
      builder.directory(command.harness().toFile()); // some Pythons import from the current folder
      try {
        return ProcessThreads.start(builder);
      } catch (IOException e) {
        throw new DiagnosticException(
            DiagnosticException.Reason.UNAVAILABLE,
            Diagnostic.of(
                PythonRules.PYTHON_UNAVAILABLE,
                "A confined Python cannot be started: " + SourceText.reason(e) + ".",
                SourceLocation.of(Path.of(line.get(0)))));
      }
    }
  }
}
