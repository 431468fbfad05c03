package dev.eventchain.sandbox;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceLocation;
import java.io.IOException;
import java.util.List;
import java.util.Map;
import java.util.concurrent.TimeUnit;

/**
 * How a process that runs foreign Python is confined.
 *
 * <p>Both ways set limits (address space, processor time, file size, open files, wall time), give
 * the process no environment variables of ours, refuse through Python's audit hooks what a
 * component has no use for (files, sockets, processes, native code, traces of frames), and ask the
 * kernel, where it can (Linux with seccomp, on x86-64 and AArch64), to refuse new processes,
 * sockets, signals to others, and the scheduling of others. They differ in what hides the files and
 * processes of this machine.
 *
 * <p>What audit hooks cannot stop: they see what the interpreter reports, so native code that opens
 * files by itself and byte code made by hand get past them; from Python 3.13 on also code that runs
 * in the middle of a check, such as a signal's handler. Namespaces hold then, or Landlock (Linux
 * 5.13); on an older kernel without bubblewrap nothing does. Neither way limits the sum of the
 * memory of files in the work folder, or hides how long something took.
 */
public enum Confinement {
  /** Namespaces of its own, made by bubblewrap: what is not given is not there. */
  BUBBLEWRAP("bubblewrap (own namespaces), seccomp, audit hooks, limits"),

  /** Python audit hooks, and Landlock where the kernel has it. */
  AUDIT_HOOKS("Python audit hooks, Landlock and seccomp where the kernel has them, limits");

  private static final String VARIABLE = "EVENTCHAIN_CONFINEMENT";
  private static final String AUTOMATIC = "auto";
  private static final List<String> PROBE =
      List.of("bwrap", "--unshare-all", "--die-with-parent", "--new-session", "--cap-drop", "ALL");
  private static final int PROBE_SECONDS = 5;

  private static Confinement detected;

  private final String description;

  Confinement(String description) {
    this.description = description;
  }

  /** For people: what holds the process. */
  public String describe() {
    return description;
  }

  /**
   * What {@code EVENTCHAIN_CONFINEMENT} names, or, if that is unset, empty or {@code auto}, the
   * strongest that works here: bubblewrap may be installed and yet be forbidden to make namespaces.
   * Found out once.
   *
   * @throws DiagnosticException {@code python.confinement.unknown} with the reason INPUT: the
   *     variable names something else; {@code python.confinement.unavailable} with the reason
   *     UNAVAILABLE: it demands bubblewrap, which does not work here
   */
  public static synchronized Confinement detect() {
    if (detected == null) {
      detected = detect(System.getenv());
    }
    return detected;
  }

  static Confinement detect(Map<String, String> settings) {
    String wanted = settings.getOrDefault(VARIABLE, "");
    return switch (wanted) {
      case "", AUTOMATIC -> bubblewrapWorks(settings) ? BUBBLEWRAP : AUDIT_HOOKS;
      case "audit-hooks" -> AUDIT_HOOKS;
      case "bubblewrap" -> demandBubblewrap(settings);
      default -> throw unknown(wanted);
    };
  }

  /**
   * What {@code EVENTCHAIN_CONFINEMENT} says, {@code auto} if it is unset or empty; whether it is
   * known is for {@link #detect()} to say. A result of code that was confined in another way may
   * not be what it would be in this one.
   */
  public static String demanded() {
    String wanted = System.getenv().getOrDefault(VARIABLE, "");
    return wanted.isEmpty() ? AUTOMATIC : wanted;
  }

  private static Confinement demandBubblewrap(Map<String, String> settings) {
    if (bubblewrapWorks(settings)) {
      return BUBBLEWRAP;
    }
    throw new DiagnosticException(
        DiagnosticException.Reason.UNAVAILABLE,
        Diagnostic.error(
                "python.confinement.unavailable",
                VARIABLE + " demands bubblewrap, which does not work here.",
                SourceLocation.NONE)
            .withHint(
                "Install bubblewrap (bwrap) and allow it to create user namespaces, or unset "
                    + VARIABLE
                    + "."));
  }

  private static DiagnosticException unknown(String wanted) {
    return new DiagnosticException(
        DiagnosticException.Reason.INPUT,
        Diagnostic.error(
                "python.confinement.unknown",
                VARIABLE
                    + " is '"
                    + wanted
                    + "', which is not a known way to confine foreign Python.",
                SourceLocation.NONE)
            .withHint(
                "Set it to bubblewrap or audit-hooks, or unset it to use the stronger one that works."));
  }

  private static boolean bubblewrapWorks(Map<String, String> settings) {
    List<String> command = new java.util.ArrayList<>(PROBE);
    command.addAll(List.of("--ro-bind", "/", "/", "--remount-ro", "/", "true"));
    ProcessBuilder builder = new ProcessBuilder(command);
    builder.environment().clear();
    builder.environment().put("PATH", settings.getOrDefault("PATH", ""));
    builder.redirectErrorStream(true).redirectOutput(ProcessBuilder.Redirect.DISCARD);
    try {
      Process process = builder.start();
      boolean ended = process.waitFor(PROBE_SECONDS, TimeUnit.SECONDS);
      process.destroyForcibly();
      return ended && process.exitValue() == 0;
    } catch (IOException e) {
      return false;
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      return false;
    }
  }
}
