package dev.eventchain.pipeline.evaluation;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.llm.chat.ChatResponse;
import dev.eventchain.pipeline.evaluation.EvaluatedRun.Host;
import dev.eventchain.pipeline.evaluation.EvaluatedRun.Score;
import dev.eventchain.pipeline.evaluation.EvaluatedRun.State;
import dev.eventchain.pipeline.evaluation.EvaluatedRun.Usage;
import dev.eventchain.pipeline.evaluation.EvaluationRow.Rate;
import dev.eventchain.pipeline.stage.Sample;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests the counting and the storage of runs. */
class EvaluationRowTest {

  private static EvaluatedRun run(boolean authored, Score code, String... failures) {
    return new EvaluatedRun(
        "m",
        1,
        State.COUNTED,
        "",
        Score.of(true, true),
        code,
        Score.of(false, false),
        "",
        authored,
        List.of("m"),
        new Usage(2, 0, 10, 5),
        List.of(failures),
        List.of(new TaskResult("design", 1, 0, 1, 100, new Usage(2, 0, 10, 5))),
        List.of(new RepairResult("design: a.b", 1, 1)),
        new Host(1));
  }

  @Test
  void onlyWhatWasJudgedIsCounted() {
    List<EvaluatedRun> runs =
        List.of(
            run(false, Score.UNKNOWN, "design: a.b"),
            run(false, Score.of(true, false), "design: a.b", "model: c.d"),
            EvaluatedRun.uncounted("m", 3, State.UNREACHABLE, "gone"));
    EvaluationRow row = EvaluationRow.of("m", runs).get(0);
    assertEquals(new Rate(1, 1), row.rate(EvaluatedRun::functionCode, false));
    assertEquals(new Rate(0, 2), row.rate(EvaluatedRun::chainModel, false));
    assertEquals(new Rate(2, 2), row.rate(EvaluatedRun::chainModel, true));
    assertEquals(Map.of("design: a.b", 2, "model: c.d", 1), row.classes(EvaluatedRun::failures));
    assertEquals(new Usage(4, 0, 20, 10), row.usage());
    assertEquals(
        List.of(new TaskResult("design", 2, 0, 2, 200, new Usage(4, 0, 20, 10))), row.tasks());
    assertEquals(List.of(new RepairResult("design: a.b", 2, 2)), row.repairs());
    assertEquals(Map.of(State.UNREACHABLE, 1), row.reasons());
  }

  private static Sample.Answer answer(
      String file, int attempt, boolean accepted, String... errors) {
    return new Sample.Answer(
        "implement",
        file,
        attempt,
        accepted,
        List.of(errors),
        10,
        Optional.of(new ChatResponse.Usage(3, 2)));
  }

  @Test
  void aRepairIsRightIfItsErrorIsGoneFromTheNextAnswer() {
    List<Sample.Answer> answers =
        List.of(
            answer("A.py", 1, false, "c.test", "c.syntax"),
            answer("B.py", 1, true),
            answer("A.py", 2, false, "c.test"),
            answer("A.py", 3, true),
            answer("C.py", 1, false, "c.test"));
    assertEquals(
        List.of(
            new RepairResult("implement: c.syntax", 1, 1),
            new RepairResult("implement: c.test", 2, 1)),
        RepairResult.of(answers),
        "what nobody answered again is no repair");
    assertEquals(
        List.of(new TaskResult("implement", 3, 1, 2, 50, new Usage(5, 0, 15, 10))),
        TaskResult.of(answers));
  }

  @Test
  void anErrorThatANewOneMayHideIsNotMended() {
    List<Sample.Answer> answers =
        List.of(
            answer("A.py", 1, false, "c.test"),
            answer("A.py", 2, false, "c.syntax"),
            answer("A.py", 1, false, "c.clock"),
            answer("A.py", 2, true));
    assertEquals(
        List.of(
            new RepairResult("implement: c.clock", 1, 1),
            new RepairResult("implement: c.test", 1, 0)),
        RepairResult.of(answers),
        "another conversation repairs nothing of an earlier one");
  }

  @Test
  void whatPeopleWroteIsNeverCountedWithAnswersOfAModel() {
    List<EvaluationRow> rows =
        EvaluationRow.of(
            "m", List.of(run(true, Score.of(true, false)), run(false, Score.of(false, false))));
    assertEquals(List.of(false, true), rows.stream().map(EvaluationRow::authored).toList());
    assertEquals(new Rate(0, 1), rows.get(0).rate(EvaluatedRun::functionCode, true));
    assertTrue(EvaluationText.label(rows).startsWith("Answers of m are authored by people"));
    assertTrue(
        EvaluationText.label(rows.subList(1, 2)).startsWith("The answers are authored by people"));
    assertEquals("", EvaluationText.label(rows.subList(0, 1)));
  }

  @Test
  void whereNothingCountsThereIsOneRowWithoutRates() {
    List<EvaluationRow> rows =
        EvaluationRow.of("m", List.of(EvaluatedRun.uncounted("m", 1, State.WAITING, "")));
    assertEquals(1, rows.size());
    assertEquals("nothing to judge", EvaluationText.cell(new Rate(0, 0)));
    assertEquals(
        "0 of 1 run counted (waiting for an answer: 1)", EvaluationText.counted(rows.get(0)));
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "../x",
        "/etc/passwd",
        "a/../../b",
        ".",
        "..",
        ".eventchain",
        "evaluation.json",
        "a\0b",
        "-o",
        "x.",
        "openai/gpt-5",
        "\u00fc"
      })
  void foldersAreSafeWhateverAModelIsCalled(String model) {
    String name = EvaluationFolder.nameOf(model, 1);
    assertTrue(name.matches("[A-Za-z0-9_][A-Za-z0-9._-]*-[0-9a-f]{8}/run-01"), name);
  }

  @Test
  void modelsHaveFoldersOfTheirOwn() {
    assertEquals("a_b/run-12", EvaluationFolder.nameOf("a_b", 12));
    assertNotEquals(EvaluationFolder.nameOf("a/b", 1), EvaluationFolder.nameOf("a:b", 1));
    String longName = "x".repeat(300);
    assertTrue(EvaluationFolder.nameOf(longName, 1).length() < 100);
    assertNotEquals(
        EvaluationFolder.nameOf(longName, 1), EvaluationFolder.nameOf(longName + "y", 1));
  }
}
