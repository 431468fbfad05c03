package dev.eventchain.lsp.session;

import java.time.Duration;

/** Notices that the process is gone that has started this one, so that no server is left over. */
final class ParentWatch {

  private static final Duration INTERVAL = Duration.ofSeconds(1);

  private ParentWatch() {}

  /** Runs something when a process is gone, or at once if it is gone already. */
  static void start(long process, Runnable gone) {
    Thread thread =
        new Thread(
            () -> {
              try {
                while (ProcessHandle.of(process).filter(ProcessHandle::isAlive).isPresent()) {
                  Thread.sleep(INTERVAL.toMillis());
                }
                gone.run();
              } catch (InterruptedException e) {
                Thread.currentThread().interrupt();
              }
            },
            "parent");
    thread.setDaemon(true);
    thread.start();
  }
}
