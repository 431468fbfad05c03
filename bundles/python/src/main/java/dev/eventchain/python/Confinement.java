package dev.eventchain.python;

import java.io.IOException;
import java.util.List;
import java.util.Map;
import java.util.concurrent.TimeUnit;

/**
 * How a process that runs foreign Python is kept in.
 *
 * <p>Both ways set limits (address space, processor time, file size, open files, wall time), give
 * the process no environment variables of ours, and ask the kernel, where it can (Linux with
 * seccomp, on x86-64 and AArch64), to refuse new processes, sockets and signals to others.
 *
 * <p>What {@link #AUDIT_HOOKS} cannot stop: audit hooks see what the interpreter reports. Native
 * code that opens files by itself, and Python code that reaches the hook's own variables (from
 * Python 3.13 on through the frames of a traceback), get past them. Where the kernel offers
 * Landlock (Linux 5.13) and seccomp, these hold then; on an older kernel nothing does. Neither way
 * limits the sum of the memory of files in the work folder, or hides how long something took.
 */
public enum Confinement {
  /** Namespaces of its own, made by bubblewrap: what is not given is not there. */
  BUBBLEWRAP("bubblewrap (own namespaces), seccomp, limits"),

  /** Python audit hooks, and Landlock where the kernel has it. */
  AUDIT_HOOKS("Python audit hooks, Landlock and seccomp where the kernel has them, limits");

  private static final List<String> PROBE =
      List.of("bwrap", "--unshare-all", "--die-with-parent", "--new-session", "--cap-drop", "ALL");
  private static final int PROBE_SECONDS = 5;

  private final String description;

  Confinement(String description) {
    this.description = description;
  }

  /** For people: what holds the process. */
  public String describe() {
    return description;
  }

  /**
   * The strongest that works here, found out once: bubblewrap may be installed and yet be forbidden
   * to make namespaces. {@code EVENTCHAIN_CONFINEMENT=audit-hooks} forces the other.
   */
  public static Confinement detect() {
    return Detected.CONFINEMENT;
  }

  static Confinement detect(Map<String, String> settings) {
    boolean forced = settings.getOrDefault("EVENTCHAIN_CONFINEMENT", "").equals("audit-hooks");
    return !forced && bubblewrapWorks(settings) ? BUBBLEWRAP : AUDIT_HOOKS;
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

  private static final class Detected {
    private static final Confinement CONFINEMENT = detect(System.getenv());
  }
}
