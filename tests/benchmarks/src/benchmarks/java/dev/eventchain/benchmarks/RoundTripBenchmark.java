package dev.eventchain.benchmarks;

import dev.eventchain.dds.DdsLibrary;
import dev.eventchain.dds.DdsParticipant;
import dev.eventchain.dds.DdsReader;
import dev.eventchain.dds.DdsSample;
import dev.eventchain.dds.DdsWriter;
import dev.eventchain.messages.CdrCodec;
import dev.eventchain.messages.MessageValue;
import dev.eventchain.messages.QosSettings;
import dev.eventchain.sandbox.PythonEnvironment;
import java.time.Duration;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.TearDown;
import org.openjdk.jmh.annotations.Warmup;

/**
 * Round trip of a scan of 360 beams to another participant over the loopback interface. Both are in
 * this process, in domains that differ for Cyclone but are the same on the wire, so that nothing is
 * passed in memory.
 */
@State(Scope.Benchmark)
@BenchmarkMode(Mode.SampleTime)
@OutputTimeUnit(TimeUnit.MICROSECONDS)
@Warmup(iterations = 3, time = 2)
@Measurement(iterations = 5, time = 2)
@Fork(1)
public class RoundTripBenchmark {

  private static final Duration PATIENCE = Duration.ofSeconds(30);

  private final byte[] bytes = CdrCodec.encode(CodecBenchmark.scan());
  private DdsParticipant here;
  private DdsParticipant there;
  private DdsWriter writer;
  private DdsReader reader;

  /** Starts the other side. */
  @Setup
  public void start() {
    DdsLibrary library =
        DdsLibrary.load(PythonEnvironment.ensureWithCycloneDds(System.err::println).cycloneDds());
    String configuration =
        DdsParticipant.loopbackConfiguration("benchmark-" + ProcessHandle.current().pid())
            .replace("<Tag>", "<ExternalDomainId>7</ExternalDomainId><Tag>");
    QosSettings qos = QosSettings.named("default").orElseThrow();
    here = DdsParticipant.on(library, 1, configuration);
    there = DdsParticipant.on(library, 2, configuration);
    writer = here.writer("/out", CodecBenchmark.TYPE, qos);
    reader = here.reader("/back", CodecBenchmark.TYPE, qos);
    DdsWriter echo = there.writer("/back", CodecBenchmark.TYPE, qos);
    DdsReader heard =
        there.reader("/out", CodecBenchmark.TYPE, qos, sample -> echo.write(sample.bytes()));
    boolean matched =
        writer.waitForMatches(1, PATIENCE)
            && reader.waitForMatches(1, PATIENCE)
            && echo.waitForMatches(1, PATIENCE)
            && heard.waitForMatches(1, PATIENCE);
    if (!matched) {
      throw new IllegalStateException("the participants do not find each other");
    }
  }

  /** Ends both sides. */
  @TearDown
  public void stop() {
    here.close();
    there.close();
  }

  /** Sends bytes and receives their echo. */
  @Benchmark
  public List<DdsSample> bytes() {
    writer.write(bytes);
    return back();
  }

  /** Sends a message and receives its echo, with encoding and decoding. */
  @Benchmark
  public MessageValue message() {
    writer.write(CdrCodec.encode(CodecBenchmark.scan()));
    return CdrCodec.decode(CodecBenchmark.TYPE, back().get(0).bytes());
  }

  private List<DdsSample> back() {
    List<DdsSample> samples = reader.take(PATIENCE);
    if (samples.size() != 1) {
      throw new IllegalStateException(samples.size() + " samples came back");
    }
    return samples;
  }
}
