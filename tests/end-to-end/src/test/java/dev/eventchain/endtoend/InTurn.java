package dev.eventchain.endtoend;

import static org.junit.jupiter.api.extension.ConditionEvaluationResult.disabled;
import static org.junit.jupiter.api.extension.ConditionEvaluationResult.enabled;

import java.lang.annotation.ElementType;
import java.lang.annotation.Retention;
import java.lang.annotation.RetentionPolicy;
import java.lang.annotation.Target;
import org.junit.jupiter.api.extension.ConditionEvaluationResult;
import org.junit.jupiter.api.extension.ExecutionCondition;
import org.junit.jupiter.api.extension.ExtendWith;
import org.junit.jupiter.api.extension.ExtensionContext;

/**
 * A test that takes long and tries a further case of what another test tries in each build. A build
 * runs a third of these, other ones each day; the profile {@code thorough} runs all. {@code
 * -Dmutants.turn=N} repeats a build's.
 */
@Target(ElementType.METHOD)
@Retention(RetentionPolicy.RUNTIME)
@ExtendWith(InTurn.Condition.class)
@interface InTurn {

  /** Lets a test run on its days. */
  final class Condition implements ExecutionCondition {
    private static final int DAYS = 3;

    @Override
    public ConditionEvaluationResult evaluateExecutionCondition(ExtensionContext context) {
      String test = context.getRequiredTestMethod().toString();
      return Thorough.IS_ON || Math.floorMod(test.hashCode() + Thorough.turn(), DAYS) == 0
          ? enabled("its day")
          : disabled("run on one day in " + DAYS + ", and in the profile 'thorough'");
    }
  }
}
