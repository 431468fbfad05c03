package dev.eventchain.dds;

import com.sun.jna.Memory;
import com.sun.jna.Pointer;
import dev.eventchain.messages.QosSettings;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;

/** A reader of messages of one topic. Thread-safe. */
public final class DdsReader extends DdsEndpoint {

  private static final int ANY_STATE = 0x7F;
  private static final int AT_ONCE = 32;
  private static final long FOREVER = Long.MAX_VALUE;

  /** {@code dds_sample_info_t}. */
  private static final long INFORMATION_SIZE = 64;

  private static final long VALID = 12;
  private static final long STAMP = 16;
  private static final long PUBLICATION = 32;

  private final int waitset;
  private final int guard;
  private final Memory pointers = new Memory((long) AT_ONCE * Long.BYTES);
  private final Memory information = new Memory(AT_ONCE * INFORMATION_SIZE);
  private Memory buffer = new Memory(4096);
  private Optional<Thread> thread = Optional.empty();
  private boolean closing;
  private boolean closed;

  DdsReader(DdsParticipant participant, DdsTopic topic, QosSettings qos) {
    super(participant, topic, Side.READER, qos);
    Cyclone cyclone = topic.cyclone();
    int condition = topic.check(cyclone.createReadcondition(handle(), ANY_STATE), "wait");
    guard = topic.check(cyclone.createGuardcondition(participant.handle()), "wait");
    waitset = topic.check(cyclone.createWaitset(participant.handle()), "wait");
    topic.check(cyclone.waitsetAttach(waitset, condition, 1), "wait");
    topic.check(cyclone.waitsetAttach(waitset, guard, 2), "wait");
  }

  /** Passes samples to a listener in a separate thread from now on. */
  synchronized void start(Consumer<DdsSample> listener) {
    Thread reading = new Thread(() -> read(listener), "dds-reader " + topic());
    reading.setDaemon(true);
    thread = Optional.of(reading);
    reading.start();
  }

  private void read(Consumer<DdsSample> listener) {
    while (true) {
      await(FOREVER);
      List<DdsSample> samples;
      synchronized (this) {
        if (closing) {
          return;
        }
        samples = takeAll();
      }
      for (DdsSample sample : samples) {
        if (isClosing()) {
          return;
        }
        try {
          listener.accept(sample);
        } catch (RuntimeException | Error e) {
          Thread current = Thread.currentThread();
          current.getUncaughtExceptionHandler().uncaughtException(current, e);
        }
      }
    }
  }

  @Override
  synchronized boolean isClosing() {
    return closing;
  }

  /**
   * Waits until there are samples or the reader closes. Does not hold the lock, so that others can
   * close it.
   */
  private void await(long nanos) {
    Samples.waitsetWait(waitset, null, 0, nanos);
  }

  /**
   * Takes the available samples, oldest first, without waiting.
   *
   * @throws IllegalStateException if the reader is closed, or has a listener
   */
  public synchronized List<DdsSample> take() {
    requireOpen();
    if (thread.isPresent()) {
      throw new IllegalStateException(
          "The samples of " + topic() + " are delivered to its listener.");
    }
    return takeAll();
  }

  /**
   * Waits for a sample, and takes the available samples.
   *
   * @return empty if none arrived within the timeout
   * @throws IllegalStateException if the reader is, or gets, closed, or has a listener
   */
  public List<DdsSample> take(Duration timeout) {
    List<DdsSample> samples = take();
    if (samples.isEmpty()) {
      await(timeout.toNanos());
      samples = take();
    }
    return samples;
  }

  private List<DdsSample> takeAll() {
    List<DdsSample> samples = new ArrayList<>();
    int count = AT_ONCE;
    while (count == AT_ONCE) {
      count =
          ddsTopic()
              .check(
                  Samples.takecdr(handle(), pointers, AT_ONCE, information, ANY_STATE),
                  "take samples");
      for (int i = 0; i < count; i++) {
        add(samples, pointers.getPointer((long) i * Long.BYTES), i * INFORMATION_SIZE);
      }
    }
    return List.copyOf(samples);
  }

  private void add(List<DdsSample> samples, Pointer data, long offset) {
    // An invalid sample reports that its writer is gone, and has no message.
    if (information.getByte(offset + VALID) != 0) {
      int size = Samples.ddsiSerdataSize(data);
      if (size > buffer.size()) {
        buffer = new Memory(size * 2L);
      }
      Samples.ddsiSerdataToSer(data, 0, size, buffer);
      samples.add(
          new DdsSample(
              buffer.getByteArray(0, size),
              information.getLong(offset + STAMP),
              information.getLong(offset + PUBLICATION)));
    }
    Samples.ddsiSerdataUnref(data);
  }

  /** Returns the events since the last call. */
  public synchronized List<DdsEvent> events() {
    requireOpen();
    return Statuses.ofReader(cyclone(), handle());
  }

  /** Closes it. Waits for a running listener, unless the listener calls this itself. */
  @Override
  public void close() {
    synchronized (this) {
      if (closed) {
        return;
      }
      closing = true;
      cyclone().setGuardcondition(guard, true);
    }
    // Without the lock, which the thread needs to finish.
    thread.filter(reading -> reading != Thread.currentThread()).ifPresent(DdsReader::join);
    synchronized (this) {
      if (closed) {
        return;
      }
      closed = true;
      cyclone().delete(waitset);
      cyclone().delete(guard);
      cyclone().delete(handle());
    }
    forget();
  }

  private static void join(Thread reading) {
    boolean interrupted = false;
    while (reading.isAlive()) {
      try {
        reading.join();
      } catch (InterruptedException e) {
        interrupted = true;
      }
    }
    if (interrupted) {
      Thread.currentThread().interrupt();
    }
  }
}
