package dev.eventchain.endtoend;

/**
 * The cut-ins of JRC-FSM (github.com/ec-jrc/JRC-FSM, commit 01b05c2), written from their
 * description and not from the example: whether a driver comes to an impact in a cell.
 *
 * @param model as the table of the cells names it
 * @param egoSpeed in km/h
 * @param otherSpeed of the vehicle that cuts in, in km/h
 * @param tenths its lateral speed, in 0.1 m/s
 * @param gap from bumper to bumper at the end of the lead-in, in m
 */
record CutInReference(String model, int egoSpeed, int otherSpeed, int tenths, int gap) {

  private static final double STEP = 0.1;
  private static final double LENGTH = 4.3;
  private static final double WIDTH = 1.9;
  private static final int SAMPLES = 350;

  /** Reads a row of the table: model, speeds, lateral speed, gap. */
  static CutInReference of(String[] row) {
    return new CutInReference(
        row[0],
        Integer.parseInt(row[1]),
        Integer.parseInt(row[2]),
        (int) Math.round(10 * Double.parseDouble(row[3])),
        Integer.parseInt(row[4]));
  }

  /** Returns whether one of the next cells of the grid has another outcome. */
  boolean isBesideTheBoundary() {
    int step = egoSpeed > 60 ? 2 : 1;
    int farthest = egoSpeed > 60 ? 119 : 59;
    boolean hits = hits();
    return (gap > step && beside(0, -step) != hits)
        || (gap < farthest && beside(0, step) != hits)
        || (tenths > 0 && beside(-1, 0) != hits)
        || (tenths < 17 && beside(1, 0) != hits);
  }

  private boolean beside(int aside, int along) {
    return new CutInReference(model, egoSpeed, otherSpeed, tenths + aside, gap + along).hits();
  }

  /** Returns whether the bodies overlap in a sample. */
  boolean hits() {
    return tenths > 0 && new Run().hits();
  }

  /** A run, from sample to sample. */
  private final class Run {

    private final double aside = tenths * 0.1;
    private final int leadIn = (int) Math.ceil(aside / 0.15);
    private final double other = otherSpeed / 3.6;
    private double speed = egoSpeed / 3.6;
    private double before = speed;
    private double distance = gap + LENGTH + (speed - other) * STEP * leadIn;
    private double offset = 3.5 + 0.0075 * leadIn * (leadIn - 1);
    private double lateral;
    private int counter = model.equals("Reg157") ? 4 : 8;
    private double braking = model.startsWith("CC") ? 0.4 : 0.0;
    private boolean ended;

    boolean hits() {
      for (int sample = 0; sample < SAMPLES + leadIn && !ended; sample++) {
        boolean moves = sample < leadIn || offset > 0.0;
        lateral = sample < leadIn ? 0.15 * sample : moves ? aside : 0.0;
        boolean last = sample == SAMPLES + leadIn - 1;
        if (!last && along() < 0.0 && across() < 0.0) {
          return true;
        }
        react();
        distance += (other - speed) * STEP;
        offset -= lateral * STEP;
      }
      return false;
    }

    private double along() {
      return Math.abs(distance) - LENGTH;
    }

    private double across() {
      return Math.abs(offset) - WIDTH;
    }

    private void react() {
      double wanted = distance >= 0.0 ? wanted() : -1.0;
      before = speed;
      if (wanted < 0.0) {
        return;
      }
      if (counter > 0) {
        counter--;
        speed -= model.startsWith("CC") ? 0.04 : 0.0;
        return;
      }
      braking = model.equals("Reg157") ? wanted : Math.min(braking + 1.265, wanted);
      speed = Math.max(0.0, speed - STEP * braking);
    }

    /** Returns the deceleration that the driver wants; -1 if it is safe. */
    private double wanted() {
      double closing = speed - other;
      double time = closing == 0.0 ? Double.POSITIVE_INFINITY : Math.abs(along() / closing);
      double full = 0.774 * 9.81;
      return switch (model) {
        case "CC_human_driver" -> {
          ended = across() <= 0.0 && time > 2.0;
          yield across() <= 0.0 && time <= 2.0 ? full : -1.0;
        }
        case "Reg157" -> across() <= 0.5 && time <= closing / 12.0 + 0.45 ? 6.0 : -1.0;
        case "RSS" -> along() < safeAlong() && across() < safeAcross() ? full : -1.0;
        case "FSM" -> passes(closing) ? -1.0 : fuzzy(closing);
        default -> throw new IllegalArgumentException(model);
      };
    }

    private double safeAlong() {
      double later = speed + 2.25;
      return 0.75 * speed + 0.84375 + (later * later - other * other) / 12.0;
    }

    private double safeAcross() {
      double later = lateral + 0.75;
      return 0.3 + (lateral + later) * 0.375 + later * later / 2.0;
    }

    private boolean passes(double closing) {
      return across() > 0.0
          && (lateral <= 0.0
              || closing < 0.0
              || (closing > 0.0 && across() / lateral > (along() + 2.0 * LENGTH) / closing + 0.1));
    }

    private double fuzzy(double closing) {
      double keeps = 0.75 * speed - other * other / 14.0;
      double square = speed * speed;
      double proactive = part(along() - 2.0, keeps + square / 12.0, keeps + square / 8.0 + 2.0);
      double critical = closing > 0.0 ? critical(closing, (speed - before) / STEP) : 0.0;
      double wanted = critical > 0.0 ? 4.0 + 2.0 * critical : 4.0 * proactive;
      return wanted == 0.0 ? -1.0 : wanted;
    }

    private double critical(double closing, double acceleration) {
      double expected = Math.max(acceleration, -4.0);
      double later = closing + 0.75 * expected;
      if (later < 0.0) {
        return along() < closing * closing / (2.0 * Math.abs(acceleration)) ? 1.0 : 0.0;
      }
      double reacting = 0.75 * (closing + 0.375 * expected);
      return part(along(), reacting + later * later / 12.0, reacting + later * later / 8.0);
    }

    private static double part(double distance, double unsafe, double safe) {
      return distance > safe ? 0.0 : distance < unsafe ? 1.0 : (distance - safe) / (unsafe - safe);
    }
  }
}
