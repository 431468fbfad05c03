package dev.eventchain.ocl;

import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;

/** What a limit is measured with. */
interface ThreadClock {

  /** The clocks of this machine. */
  ThreadClock SYSTEM =
      new ThreadClock() {
        @Override
        public long wall() {
          return System.nanoTime();
        }

        @Override
        public long processor() {
          long nanos = Processor.BEAN == null ? -1 : Processor.BEAN.getCurrentThreadCpuTime();
          return nanos < 0 ? wall() : nanos;
        }
      };

  /** Nanoseconds of a clock on the wall, from an arbitrary start. */
  long wall();

  /**
   * Nanoseconds for which a processor worked for the calling thread, from an arbitrary start; wall
   * time where Java cannot tell. A hundred times as dear as {@link #wall}.
   */
  long processor();

  /** Loaded when a limit is first looked at closely, as it takes ten milliseconds. */
  final class Processor {
    private static final ThreadMXBean BEAN = find();

    private Processor() {}

    private static ThreadMXBean find() {
      ThreadMXBean bean = ManagementFactory.getThreadMXBean();
      return bean.isCurrentThreadCpuTimeSupported() && bean.isThreadCpuTimeEnabled() ? bean : null;
    }
  }
}
