package dev.eventchain.benchmarks;

import dev.eventchain.messages.CdrCodec;
import dev.eventchain.messages.MessageCatalog;
import dev.eventchain.messages.MessageType;
import dev.eventchain.messages.MessageValue;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.Warmup;

/** A scan of 360 beams with as many intensities, 2.9 kB, encoded and decoded. */
@State(Scope.Benchmark)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.NANOSECONDS)
@Warmup(iterations = 3, time = 1)
@Measurement(iterations = 5, time = 1)
@Fork(1)
public class CodecBenchmark {

  static final MessageType TYPE =
      MessageCatalog.of(List.of()).find("sensor_msgs/msg/LaserScan").orElseThrow();

  private final MessageValue scan = scan();
  private final byte[] bytes = CdrCodec.encode(scan);

  static MessageValue scan() {
    float[] ranges = new float[360];
    for (int i = 0; i < ranges.length; i++) {
      ranges[i] = 0.25f * i;
    }
    return MessageValue.of(TYPE)
        .set("header.frame_id", "lidar")
        .set("range_max", 100)
        .set("ranges", ranges)
        .set("intensities", new float[360]);
  }

  /** Encodes the message. */
  @Benchmark
  public byte[] write() {
    return CdrCodec.encode(scan);
  }

  /** Decodes the message. */
  @Benchmark
  public MessageValue read() {
    return CdrCodec.decode(TYPE, bytes);
  }

  /** Encodes and decodes the message. */
  @Benchmark
  public MessageValue writeAndRead() {
    return CdrCodec.decode(TYPE, CdrCodec.encode(scan));
  }

  /** Runs the check of a DDS writer before the library gets the bytes. */
  @Benchmark
  public byte[] check() {
    CdrCodec.requireMessage(TYPE, bytes);
    return bytes;
  }
}
