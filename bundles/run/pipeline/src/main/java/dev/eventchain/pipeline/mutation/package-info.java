/** Mutation testing: which small defects of components their tests and the scenarios notice. */
package dev.eventchain.pipeline.mutation;
