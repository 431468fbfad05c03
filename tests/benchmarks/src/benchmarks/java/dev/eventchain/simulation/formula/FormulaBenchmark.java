package dev.eventchain.simulation.formula;

import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.simulation.world.Trace;
import dev.eventchain.simulation.world.VehicleCommand;
import dev.eventchain.simulation.world.World;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.Warmup;

/**
 * Formulas on a run of 10,000 s, which is a million samples. It is in the package of the formulas,
 * since these are no public API. Handwritten Java computes only the verdict, not the decisive
 * comparison.
 */
@State(Scope.Benchmark)
@BenchmarkMode(Mode.SingleShotTime)
@OutputTimeUnit(TimeUnit.MILLISECONDS)
@Warmup(iterations = 5)
@Measurement(iterations = 10)
@Fork(value = 1, jvmArgs = "-Xmx1g")
public class FormulaBenchmark {

  private static final int SAMPLES = 1_000_000;
  private static final int QUARTER_SECOND = 25;
  private static final int SECOND = 100;
  private static final double FULL = 0.89;

  /** The judged cases. */
  public enum Case {
    /** A comparison at each sample. */
    INVARIANT("always gap > 1 m"),
    /** A window at each sample. */
    RESPONSE("always (ttc < 1 s implies eventually[0,0.25] brake >= 0.89)"),
    /** Arithmetic of units and a window that starts later. */
    TRACKING("always[5,9000] abs(ego.speed - 50 km/h) <= 5 km/h"),
    /** Two conditions in order, at each sample. */
    ORDER("always (gap > 6 m until[0,1] ego.speed > 46 km/h)");

    private final String formula;

    Case(String formula) {
      this.formula = formula;
    }
  }

  /** The judged case. */
  @Param public Case judged;

  private Trace trace;
  private Formula formula;

  /** Creates the run and compares the verdicts. */
  @Setup
  public void prepare() {
    trace = new Trace();
    for (int i = 0; i < SAMPLES; i++) {
      double speed = 50 / 3.6 + Math.sin(i * 1e-3);
      double gap = 10 + 3 * Math.cos(i * 1e-4);
      double timeToCollision = i % 1000 < 30 ? 0.9 : 5;
      trace.state(
          new Trace.State(
              i * World.TRACE_STEP, speed, gap, timeToCollision, 0, 0, 0, Trace.Pose.STRAIGHT));
      if (i % 1000 == 0 || i % 1000 == 60) {
        trace.command(i * World.TRACE_STEP, VehicleCommand.brake(i % 1000 == 0 ? 1 : 0));
      }
    }
    formula =
        Formula.parse(
            SourceText.of("f", judged.formula).whole(), new WorldSignals(), SAMPLES / 100.0);
    if (eventchain() != javaByHand()) {
      throw new IllegalStateException(judged + " is judged otherwise by hand");
    }
  }

  /** Computes the verdict, the decisive comparison, its margin and its time with this project. */
  @Benchmark
  public boolean eventchain() {
    Outcome outcome = formula.judge(trace);
    if (!outcome.tested()) {
      throw new IllegalStateException(outcome.detail());
    }
    return outcome.passed();
  }

  /** Computes the verdict with handwritten Java. */
  @Benchmark
  public boolean javaByHand() {
    List<Trace.State> states = trace.states();
    return switch (judged) {
      case INVARIANT -> states.stream().allMatch(state -> state.gap() > 1);
      case RESPONSE -> responds(states);
      case TRACKING -> tracks(states);
      case ORDER -> inOrder(states);
    };
  }

  private boolean responds(List<Trace.State> states) {
    int next = trace.commands().size();
    int latest = Integer.MAX_VALUE;
    for (int i = states.size() - 1; i >= 0; i--) {
      while (next > 0 && trace.commands().get(next - 1).time() > states.get(i).time()) {
        next--;
      }
      double pedal = next == 0 ? 0 : trace.commands().get(next - 1).pedal();
      latest = pedal >= FULL ? i : latest;
      boolean late = latest > i + QUARTER_SECOND && i + QUARTER_SECOND < states.size();
      if (states.get(i).timeToCollision() < 1 && late) {
        return false;
      }
    }
    return true;
  }

  private static boolean tracks(List<Trace.State> states) {
    for (int i = 5 * SECOND; i <= 9000 * SECOND; i++) {
      if (Math.abs(states.get(i).speed() - 50 / 3.6) > 5 / 3.6) {
        return false;
      }
    }
    return true;
  }

  private static boolean inOrder(List<Trace.State> states) {
    int reached = Integer.MAX_VALUE;
    int lost = Integer.MAX_VALUE;
    for (int i = states.size() - 1; i >= 0; i--) {
      reached = states.get(i).speed() > 46 / 3.6 ? i : reached;
      lost = states.get(i).gap() > 6 ? lost : i;
      boolean inTime = reached <= i + SECOND && lost >= reached;
      if (!inTime && i + SECOND < states.size()) {
        return false;
      }
    }
    return true;
  }
}
