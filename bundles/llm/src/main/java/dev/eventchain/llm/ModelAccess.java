package dev.eventchain.llm;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.llm.service.ModelServices;
import java.nio.file.Path;
import java.util.function.Consumer;
import java.util.function.UnaryOperator;

/**
 * Access of one run to language models.
 *
 * @param source source of the answers: {@code replay} takes them from the recordings, {@code live}
 *     asks the services, {@code auto} the services for missing recordings, {@code handoff:FOLDER} a
 *     person through files in that folder for missing recordings, {@code command:PROGRAM ARGUMENTS}
 *     a program; {@code SERVICE/MODEL} is {@code live} with that model for every task
 * @param recordings the folder of the recordings, {@code TASK/NAME-KEY.json} in the format {@code
 *     llm-recording/1}
 * @param record true to record new answers
 * @param services the services and their prices
 * @param spending the cost of the run so far
 * @param environment the value of an environment variable, null if it is not set
 * @param progress receives frequent progress messages for the user
 * @param findings receives findings about received answers
 */
public record ModelAccess(
    String source,
    Path recordings,
    boolean record,
    ModelServices services,
    Spending spending,
    UnaryOperator<String> environment,
    Consumer<String> progress,
    Consumer<Diagnostic> findings) {

  /** Returns an access with the usual services, no budget and no listeners. */
  public static ModelAccess of(String source, Path recordings, boolean record) {
    ModelServices services = ModelServices.usual();
    return new ModelAccess(
        source,
        recordings,
        record,
        services,
        new Spending(services),
        System::getenv,
        message -> {},
        finding -> {});
  }
}
