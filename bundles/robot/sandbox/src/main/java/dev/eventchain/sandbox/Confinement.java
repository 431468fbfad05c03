package dev.eventchain.sandbox;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceLocation;
import java.io.IOException;
import java.util.List;
import java.util.Map;
import java.util.concurrent.TimeUnit;

/**
 * Ways to confine a process that runs untrusted Python.
 *
 * <p>Both ways limit address space, processor time, file size, open files and wall time, and give
 * the process no environment variables of ours. Python's audit hooks refuse what a component does
 * not need: files, sockets, processes, native code, frame tracing. On Linux on x86-64 and AArch64,
 * seccomp refuses new processes, sockets, signals to others, and the scheduling of others. The ways
 * differ in how they hide the files and processes of this machine.
 *
 * <p>Limits of audit hooks: they see only events that the interpreter reports. Native code that
 * opens files by itself and hand-made byte code bypass them; from Python 3.13 on also code that
 * runs during a check, such as a signal handler. Namespaces or Landlock (Linux 5.13) still apply
 * then; nothing stops them on an older kernel without bubblewrap. Neither way limits the total size
 * of files in the work folder, or prevents timing measurements.
 */
public enum Confinement {
  /** Separate namespaces, created by bubblewrap: only the given files exist. */
  BUBBLEWRAP("bubblewrap (own namespaces), seccomp, audit hooks, limits"),

  /** Python audit hooks, and Landlock where the kernel supports it. */
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

  /** Returns a description for the user. */
  public String describe() {
    return description;
  }

  /**
   * Returns the confinement that {@code EVENTCHAIN_CONFINEMENT} names. If it is unset, empty or
   * {@code auto}, returns the strongest that works here: bubblewrap may be installed but forbidden
   * to create namespaces. Determined once.
   *
   * @throws DiagnosticException {@code python.confinement.unknown} with the reason INPUT: the
   *     variable has another value; {@code python.confinement.unavailable} with the reason
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
   * Returns the value of {@code EVENTCHAIN_CONFINEMENT}, {@code auto} if it is unset or empty,
   * without validation, see {@link #detect()}. Results of code may differ between confinements.
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
        Diagnostic.of(
                PythonRules.PYTHON_CONFINEMENT_UNAVAILABLE,
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
        Diagnostic.of(
                PythonRules.PYTHON_CONFINEMENT_UNKNOWN,
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
