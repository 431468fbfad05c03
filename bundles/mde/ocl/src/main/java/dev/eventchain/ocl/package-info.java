/**
 * The language OCL over some metamodels: parsing, definitions, evaluation, and the reasons of false
 * and undefined values. The API for other bundles, without types of Eclipse OCL.
 */
package dev.eventchain.ocl;
