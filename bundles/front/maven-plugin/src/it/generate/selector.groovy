// Built on one day in three, and in the profile 'thorough'.
import java.time.LocalDate
import java.time.ZoneOffset

return part == "1" || Long.getLong("mutants.turn", LocalDate.now(ZoneOffset.UTC).toEpochDay()) % 3 == 0
