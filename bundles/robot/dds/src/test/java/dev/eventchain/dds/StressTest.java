package dev.eventchain.dds;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.messages.CdrCodec;
import dev.eventchain.messages.MessageType;
import dev.eventchain.messages.MessageValue;
import dev.eventchain.messages.QosSettings;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Queue;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.Test;

/** Threads that write and take while their participant is closed. */
class StressTest {

  private static final int ROUNDS = 30;
  private static final MessageType SCAN = RandomMessages.type("sensor_msgs/msg/LaserScan");

  private final Queue<Throwable> unexpected = new ConcurrentLinkedQueue<>();
  private final AtomicInteger written = new AtomicInteger();
  private final AtomicInteger heard = new AtomicInteger();

  @Test
  void closingWhileOthersWriteAndTakeIsAnExceptionForThem() throws InterruptedException {
    for (int round = 0; round < ROUNDS; round++) {
      close(round);
    }
    assertEquals(List.of(), List.copyOf(unexpected));
    assertTrue(written.get() >= 2 * ROUNDS, "only " + written + " were written");
    assertTrue(heard.get() > 0, "none was heard");
  }

  private void close(int round) throws InterruptedException {
    QosSettings qos = QosSettings.named("default").orElseThrow();
    byte[] bytes = CdrCodec.encode(MessageValue.of(SCAN).set("ranges", new float[360]));
    DdsParticipant participant = Wire.alone();
    DdsWriter writer = participant.writer("/scan", SCAN, qos);
    DdsReader taken = participant.reader("/scan", SCAN, qos);
    DdsReader listening = participant.reader("/scan", SCAN, qos, sample -> heard.incrementAndGet());
    CountDownLatch begun = new CountDownLatch(4);
    List<Thread> threads = new ArrayList<>();
    threads.add(start(begun, () -> write(writer, bytes)));
    threads.add(start(begun, () -> write(writer, bytes)));
    threads.add(start(begun, () -> taken.take(Duration.ofSeconds(1))));
    threads.add(start(begun, taken::matched));
    assertTrue(begun.await(2, TimeUnit.MINUTES));
    switch (round % 3) {
      case 0 -> participant.close();
      case 1 -> {
        writer.close();
        taken.close();
      }
      default -> {
        listening.close();
        taken.close();
        writer.close();
      }
    }
    for (Thread thread : threads) {
      thread.join(TimeUnit.MINUTES.toMillis(2));
      assertTrue(!thread.isAlive(), "a thread goes on in round " + round);
    }
    participant.close();
  }

  private void write(DdsWriter writer, byte[] bytes) {
    if (writer.write(bytes)) {
      written.incrementAndGet();
    }
  }

  /** Starts a thread that works until it is refused. */
  private Thread start(CountDownLatch begun, Runnable work) {
    Thread thread =
        new Thread(
            () -> {
              try {
                work.run();
                begun.countDown();
                while (true) {
                  work.run();
                }
              } catch (IllegalStateException e) {
                if (!String.valueOf(e.getMessage()).endsWith(" is closed.")) {
                  unexpected.add(e);
                }
              } catch (RuntimeException | Error e) {
                unexpected.add(e);
              }
            });
    thread.start();
    return thread;
  }

  @Test
  void aListenerMayCloseItsReaderAndItsParticipant() throws InterruptedException {
    QosSettings qos = QosSettings.named("default").orElseThrow();
    for (boolean all : new boolean[] {true, false}) {
      DdsParticipant participant = Wire.alone();
      DdsWriter writer = participant.writer("/scan", SCAN, qos);
      CountDownLatch closed = new CountDownLatch(1);
      List<DdsReader> readers = new ArrayList<>();
      synchronized (readers) {
        readers.add(
            participant.reader(
                "/scan",
                SCAN,
                qos,
                sample -> {
                  synchronized (readers) {
                    readers.get(0).close();
                  }
                  if (all) {
                    participant.close();
                  }
                  closed.countDown();
                }));
      }
      assertTrue(writer.waitForMatches(1, Wire.PATIENCE));
      assertTrue(writer.write(CdrCodec.encode(MessageValue.of(SCAN))));
      assertTrue(closed.await(2, TimeUnit.MINUTES));
      participant.close();
    }
  }

  @Test
  void participantsComeAndGo() {
    QosSettings qos = QosSettings.named("default").orElseThrow();
    String tag = Wire.newTag();
    try (DdsParticipant staying = Wire.onTheWire(tag)) {
      DdsWriter writer = staying.writer("/scan", SCAN, qos);
      for (int i = 0; i < 20; i++) {
        try (DdsParticipant passing = Wire.onTheWire(tag)) {
          DdsReader reader = passing.reader("/scan", SCAN, qos);
          Wire.connect(writer, reader);
          assertTrue(writer.write(CdrCodec.encode(MessageValue.of(SCAN)), i));
          assertEquals(i, reader.take(Wire.PATIENCE).get(0).sourceTimestamp());
        }
        long start = System.nanoTime();
        while (writer.matched() > 0 && System.nanoTime() - start < Wire.PATIENCE.toNanos()) {
          Thread.onSpinWait();
        }
        assertEquals(0, writer.matched());
      }
    }
  }
}
