package dev.eventchain.sandbox;

import com.fasterxml.jackson.databind.JsonNode;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicReference;
import java.util.stream.Stream;

/**
 * A Python process that runs an untrusted program.
 *
 * <p>It reads Python itself, the system's libraries and the paths it is given, writes its work
 * folder and nothing else, has no network except what {@link Builder#preparation} made, starts no
 * processes, and ends when it uses more than its limits, when it is closed, or when this Java ends.
 * It sees no environment variables but those that make it repeatable ({@code PYTHONHASHSEED=0},
 * UTF-8, no byte code files); home and temporary folder are the work folder. See {@link
 * Confinement} for what this rests on.
 *
 * <p>Standard output is the caller's to read; a process whose output is not read blocks until its
 * time is up. Standard error is always read and its first and last parts are kept; one that writes
 * more than 16 MiB there is ended.
 */
public final class ConfinedProcess implements AutoCloseable {

  /**
   * What the process may use.
   *
   * @param wallTime from its start until it is killed
   * @param cpuTime processor time, whole seconds, rounded up
   * @param memoryMiB address space in MiB; Python with NumPy needs about 100
   */
  public record Limits(Duration wallTime, Duration cpuTime, int memoryMiB) {}

  /** Why a process ended. */
  public enum Cause {
    /** By itself, or by a signal that it caused. */
    EXITED,
    /** It used up its wall time. */
    WALL_TIME,
    /** It used up its processor time. */
    CPU_TIME,
    /** It wrote more to standard error than anybody reads. */
    OUTPUT,
    /** {@link ConfinedProcess#close} or an interrupt of the waiting thread. */
    CLOSED
  }

  /**
   * How a process ended.
   *
   * @param exitCode its exit code; 128 plus the number of the signal that ended it
   */
  public record Termination(Cause cause, int exitCode) {
    /** Whether it ended by itself with 0. */
    public boolean isSuccess() {
      return cause == Cause.EXITED && exitCode == 0;
    }
  }

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

  /** Describes a process on this Python. */
  public static Builder on(PythonEnvironment environment) {
    return new Builder(environment);
  }

  /** Where the program reads its standard input from. */
  public OutputStream stdin() {
    return process.getOutputStream();
  }

  /** What the program writes to its standard output. */
  public InputStream stdout() {
    return process.getInputStream();
  }

  /** What it wrote to standard error until now, shortened in the middle beyond 64 KiB. */
  public String standardError() {
    return standardError.text();
  }

  /**
   * Processor time that it and the processes below it have used so far, of those that still run.
   */
  public Duration processorTime() {
    return processes()
        .map(handle -> handle.info().totalCpuDuration().orElse(Duration.ZERO))
        .reduce(Duration.ZERO, Duration::plus);
  }

  /**
   * Whether a signal has stopped it, or a process below it, as SIGSTOP does; false where that
   * cannot be told.
   */
  public boolean isStopped() {
    return processes().anyMatch(handle -> ProcessState.of(handle.pid()).isStopped());
  }

  /** It and the processes below it. */
  Stream<ProcessHandle> processes() {
    return Stream.concat(Stream.of(process.toHandle()), process.descendants());
  }

  /** Whether it still runs. */
  public boolean isAlive() {
    return process.isAlive();
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

  /** Ends it, if it has not ended by itself. */
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
  }

  void kill(Cause why) {
    if (process.isAlive() && cause.compareAndSet(Cause.EXITED, why)) {
      process.descendants().forEach(ProcessHandle::destroyForcibly);
      process.destroyForcibly();
    }
  }

  /** Describes a process: a program, a work folder and limits are needed. */
  public static final class Builder {

    private final ConfinedCommand command;
    private Duration wallTime = Duration.ofSeconds(10);

    private Builder(PythonEnvironment environment) {
      this.command = new ConfinedCommand(environment);
      limits(new Limits(wallTime, wallTime, 512));
    }

    /** Runs a script file. Its own folder is not searched for modules: see {@link #pythonPath}. */
    public Builder script(Path script) {
      command.program("script", script.toAbsolutePath().toString());
      return readable(script);
    }

    /** Runs a module of the {@link #pythonPath} as {@code python -m} does. */
    public Builder module(String name) {
      command.program("module", name);
      return this;
    }

    /**
     * The program calls components through {@code component_client.py}: each then lives in its own
     * process, which may write nothing but a folder of its own in the work folder, and has these
     * limits for itself.
     *
     * @param turn which of several such processes this is: each stays on one processor, and they
     *     should not meet there
     */
    public Builder components(int turn) {
      command.components(turn);
      return this;
    }

    /**
     * Before it gives up its rights, the process calls {@code prepare} of a module of the {@link
     * #pythonPath}, one of our own, to make what the program needs and may not make: sockets on
     * this machine's network, and threads for them. What is made there stays; the program itself
     * opens no others.
     */
    public Builder preparation(String module, JsonNode settings) {
      command.preparation(module, settings);
      return this;
    }

    /** The arguments of the program. */
    public Builder arguments(String... arguments) {
      command.arguments(List.of(arguments));
      return this;
    }

    /** The only folder that the program may write, and its current folder; it has to exist. */
    public Builder workFolder(Path folder) {
      command.workFolder(folder);
      return this;
    }

    /** Files and folders that the program may read besides Python and its packages. */
    public Builder readable(Path... paths) {
      command.readable(List.of(paths));
      return this;
    }

    /**
     * Folders of our own Python sources to import from, readable and, for a fast start, compiled
     * ahead of time if they can be written.
     */
    public Builder pythonPath(Path... folders) {
      command.pythonPath(List.of(folders));
      return this;
    }

    /** Ten seconds and 512 MiB unless this says otherwise. */
    public Builder limits(Limits limits) {
      wallTime = limits.wallTime();
      command.limits(limits);
      return this;
    }

    /** How to confine it; {@link Confinement#detect} unless this says otherwise. */
    public Builder confinement(Confinement confinement) {
      command.confinement(confinement);
      return this;
    }

    /** For tests of what one layer stops alone. */
    Builder withoutKernel() {
      command.withoutKernel();
      return this;
    }

    /** For tests of what the other layers stop alone. */
    Builder withoutHooks() {
      command.withoutHooks();
      return this;
    }

    /**
     * Starts it.
     *
     * @throws DiagnosticException {@code python.unavailable}: the process cannot be started
     */
    public ConfinedProcess start() {
      ProcessBuilder builder = new ProcessBuilder(command.line());
      builder.environment().clear();
      builder.environment().putAll(command.settings());
      try {
        return new ConfinedProcess(ProcessThreads.start(builder), wallTime);
      } catch (IOException e) {
        throw new DiagnosticException(
            DiagnosticException.Reason.UNAVAILABLE,
            Diagnostic.error(
                "python.unavailable",
                "A confined Python cannot be started: " + SourceText.reason(e) + ".",
                SourceLocation.of(Path.of(command.line().get(0)))));
      }
    }
  }
}
