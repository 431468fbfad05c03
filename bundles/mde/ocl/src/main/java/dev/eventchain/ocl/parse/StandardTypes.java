package dev.eventchain.ocl.parse;

import java.util.List;
import org.eclipse.emf.ecore.EClassifier;
import org.eclipse.ocl.ecore.CollectionType;
import org.eclipse.ocl.ecore.EcoreEnvironmentFactory;
import org.eclipse.ocl.types.OCLStandardLibrary;
import org.eclipse.ocl.utilities.PredefinedType;

/** The types of OCL's standard library, which all environments of a program share. */
final class StandardTypes {

  private StandardTypes() {}

  /**
   * Has each type collect its operations. Eclipse OCL does so on first use and without a lock: of
   * two threads, one could remove all operations of a collection as iterators, for as long as the
   * program runs.
   */
  static void complete() {
    OCLStandardLibrary<EClassifier> library =
        EcoreEnvironmentFactory.INSTANCE.createEnvironment().getOCLStandardLibrary();
    for (EClassifier type : typesOf(library)) {
      if (type instanceof CollectionType collection) {
        collection.oclIterators();
      }
      if (type instanceof PredefinedType<?> predefined) {
        predefined.oclOperations();
      }
    }
  }

  private static List<EClassifier> typesOf(OCLStandardLibrary<EClassifier> library) {
    return List.of(
        library.getOclAny(),
        library.getOclElement(),
        library.getOclVoid(),
        library.getOclInvalid(),
        library.getOclMessage(),
        library.getOclType(),
        library.getOclExpression(),
        library.getState(),
        library.getBoolean(),
        library.getString(),
        library.getInteger(),
        library.getUnlimitedNatural(),
        library.getReal(),
        library.getT(),
        library.getT2(),
        library.getCollection(),
        library.getSet(),
        library.getOrderedSet(),
        library.getBag(),
        library.getSequence());
  }
}
