package dev.eventchain.llm.service;

import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteBuffer;
import java.time.Duration;
import java.util.ArrayDeque;
import java.util.List;
import java.util.Queue;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.Flow;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;

/**
 * The body of a response as a stream with time limits: the deadline of the whole call, however
 * slowly bytes arrive, and a maximal silence. An interrupted reader ends the exchange.
 */
public final class BodyStream extends InputStream implements Flow.Subscriber<List<ByteBuffer>> {

  /** Maximal size of an answer in bytes. */
  public static final long LONGEST = 32L << 20;

  private static final Object END = new Object();

  private final Deadline deadline;
  private final Duration patience;
  private final BlockingQueue<Object> arrived = new LinkedBlockingQueue<>();
  private final Queue<ByteBuffer> buffers = new ArrayDeque<>();
  private volatile Flow.Subscription subscription;
  private boolean ended;
  private long received;

  BodyStream(Deadline deadline, Duration patience) {
    this.deadline = deadline;
    this.patience = patience;
  }

  @Override
  public void onSubscribe(Flow.Subscription toBody) {
    subscription = toBody;
    toBody.request(1);
  }

  @Override
  public void onNext(List<ByteBuffer> item) {
    arrived.add(item);
  }

  @Override
  public void onError(Throwable throwable) {
    arrived.add(throwable);
  }

  @Override
  public void onComplete() {
    arrived.add(END);
  }

  @Override
  public int read() throws IOException {
    byte[] one = new byte[1];
    return read(one, 0, 1) < 0 ? -1 : one[0] & 0xFF;
  }

  @Override
  public int read(byte[] target, int offset, int length) throws IOException {
    while (!ended && (buffers.isEmpty() || !buffers.peek().hasRemaining())) {
      buffers.poll();
      if (buffers.isEmpty()) {
        await();
      }
    }
    if (ended) {
      return -1;
    }
    int count = Math.min(length, buffers.peek().remaining());
    buffers.peek().get(target, offset, count);
    return count;
  }

  private void await() throws IOException {
    Object next = poll();
    if (next == END) {
      ended = true;
    } else if (next instanceof Throwable problem) {
      throw new IOException(problem.getMessage(), problem);
    } else {
      for (Object buffer : (List<?>) next) {
        received += ((ByteBuffer) buffer).remaining();
        buffers.add((ByteBuffer) buffer);
      }
      if (received > LONGEST) {
        close();
        throw new CallFailure(
            CallFailure.Kind.UNREADABLE,
            "the answer is longer than " + (LONGEST >> 20) + " MiB",
            "Ask another model.");
      }
      subscription.request(1);
    }
  }

  private Object poll() {
    Duration wait = deadline.atMost(patience);
    try {
      Object next = arrived.poll(wait.toNanos(), TimeUnit.NANOSECONDS);
      if (next != null) {
        return next;
      }
    } catch (InterruptedException e) {
      close();
      throw deadline.interrupted();
    }
    close();
    throw deadline.hasPassed() ? deadline.passed() : silent();
  }

  private CallFailure silent() {
    return new CallFailure(
        CallFailure.Kind.LATE,
        "nothing arrived for " + Deadline.text(patience) + " in the middle of the answer",
        "Try again, or allow more with 'silence_s' of the service in eventchain.yaml.");
  }

  /** Ends the exchange; the connection is not reused. */
  @Override
  public void close() {
    ended = true;
    if (subscription != null) {
      subscription.cancel();
    }
  }
}
