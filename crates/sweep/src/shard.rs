//! Shards: rows of consecutive cases as one Parquet file.

use crate::case::Row;
use crate::study_file::StudyFile;
use parquet::basic::{ConvertedType, Repetition, Type as Physical};
use parquet::column::reader::ColumnReader;
use parquet::data_type::{ByteArray, ByteArrayType, DoubleType, Int64Type};
use parquet::errors::{ParquetError, Result};
use parquet::file::metadata::KeyValue;
use parquet::file::properties::WriterProperties;
use parquet::file::reader::{FileReader as _, RowGroupReader, SerializedFileReader};
use parquet::file::writer::{SerializedFileWriter, SerializedRowGroupWriter};
use parquet::schema::types::{Type, TypePtr};
use sha2::{Digest, Sha256};
use std::fmt::Write as _;
use std::fs::File;
use std::path::Path;
use std::sync::Arc;

/// Names of what a shard says about itself.
const IDENTITY: &str = "slideline.study";
const CHECKSUM: &str = "slideline.checksum";

/// Columns: the case, the parameters, the responses, the code.
fn schema(study: &StudyFile) -> Result<TypePtr> {
    let column = |name: &str, physical, repetition, converted| {
        let own = Type::primitive_type_builder(name, physical);
        own.with_repetition(repetition).with_converted_type(converted).build().map(Arc::new)
    };
    let none = ConvertedType::NONE;
    let mut fields = vec![column("case", Physical::INT64, Repetition::REQUIRED, none)?];
    for (name, _) in &study.parameters {
        fields.push(column(name, Physical::DOUBLE, Repetition::REQUIRED, none)?);
    }
    for name in &study.responses {
        fields.push(column(name, Physical::DOUBLE, Repetition::OPTIONAL, none)?);
    }
    let text = ConvertedType::UTF8;
    fields.push(column("code", Physical::BYTE_ARRAY, Repetition::OPTIONAL, text)?);
    Type::group_type_builder("study").with_fields(fields).build().map(Arc::new)
}

/// The bytes of a shard.
pub(crate) fn bytes(study: &StudyFile, identity: &str, rows: &[Row]) -> Result<Vec<u8>> {
    let said = [(IDENTITY, identity.to_owned()), (CHECKSUM, checksum(rows))];
    let said = said.map(|(key, value)| KeyValue::new(key.to_owned(), value)).to_vec();
    let properties = WriterProperties::builder()
        .set_created_by(format!("slideline {}", slideline::VERSION))
        .set_key_value_metadata(Some(said))
        .set_dictionary_enabled(false)
        .build();
    let mut writer = SerializedFileWriter::new(Vec::new(), schema(study)?, Arc::new(properties))?;
    let mut group = writer.next_row_group()?;
    write_columns(study, &mut group, rows)?;
    group.close()?;
    writer.into_inner()
}

fn write_columns(
    study: &StudyFile,
    group: &mut SerializedRowGroupWriter<'_, Vec<u8>>,
    rows: &[Row],
) -> Result<()> {
    let missing = || ParquetError::General("a column is missing".to_owned());
    let cases: Vec<i64> = rows.iter().map(|row| row.case.cast_signed()).collect();
    let mut column = group.next_column()?.ok_or_else(missing)?;
    column.typed::<Int64Type>().write_batch(&cases, None, None)?;
    column.close()?;
    for place in 0..study.parameters.len() {
        let values: Vec<f64> = rows.iter().map(|row| row.values[place]).collect();
        let mut column = group.next_column()?.ok_or_else(missing)?;
        column.typed::<DoubleType>().write_batch(&values, None, None)?;
        column.close()?;
    }
    for place in 0..study.responses.len() {
        let values: Vec<f64> = rows.iter().filter_map(|row| row.responses[place]).collect();
        let is_there: Vec<i16> =
            rows.iter().map(|row| i16::from(row.responses[place].is_some())).collect();
        let mut column = group.next_column()?.ok_or_else(missing)?;
        column.typed::<DoubleType>().write_batch(&values, Some(&is_there), None)?;
        column.close()?;
    }
    let codes: Vec<ByteArray> =
        rows.iter().filter_map(|row| Some(row.code.as_deref()?.into())).collect();
    let is_there: Vec<i16> = rows.iter().map(|row| i16::from(row.code.is_some())).collect();
    let mut column = group.next_column()?.ok_or_else(missing)?;
    column.typed::<ByteArrayType>().write_batch(&codes, Some(&is_there), None)?;
    column.close()
}

/// SHA-256 over the bits of all rows, in hexadecimal digits.
fn checksum(rows: &[Row]) -> String {
    let mut digest = Sha256::new();
    for row in rows {
        digest.update(row.case.to_le_bytes());
        row.values.iter().for_each(|value| digest.update(value.to_bits().to_le_bytes()));
        for value in &row.responses {
            digest.update([u8::from(value.is_some())]);
            digest.update(value.unwrap_or_default().to_bits().to_le_bytes());
        }
        digest.update(row.code.as_deref().unwrap_or_default().as_bytes());
        digest.update([0]);
    }
    hexadecimal(&digest.finalize())
}

/// Bytes in hexadecimal digits.
pub(crate) fn hexadecimal(bytes: &[u8]) -> String {
    bytes.iter().fold(String::new(), |mut text, byte| {
        let _ = write!(text, "{byte:02x}"); // a String takes any text
        text
    })
}

/// What a file that should be a shard is.
pub(crate) enum Found {
    /// The rows of the cases.
    Rows(Vec<Row>),
    /// It was not written yet.
    Missing,
    /// It cannot be used; why.
    Damaged(String),
}

/// Reads the shard of these cases.
pub(crate) fn read(
    path: &Path,
    study: &StudyFile,
    identity: &str,
    cases: std::ops::Range<u64>,
) -> Found {
    let file = match File::open(path) {
        Ok(file) => file,
        Err(reason) if reason.kind() == std::io::ErrorKind::NotFound => return Found::Missing,
        Err(reason) => return Found::Damaged(reason.to_string()),
    };
    match rows(file, study, identity) {
        Ok(rows) if rows.iter().map(|row| row.case).eq(cases) => Found::Rows(rows),
        Ok(_) => Found::Damaged("it holds other cases".to_owned()),
        Err(reason) => Found::Damaged(reason.to_string()),
    }
}

fn rows(file: File, study: &StudyFile, identity: &str) -> Result<Vec<Row>> {
    let wrong = |what: &str| ParquetError::General(what.to_owned());
    let reader = SerializedFileReader::new(file)?;
    let file = reader.metadata().file_metadata();
    let said = |key: &str| {
        let all = file.key_value_metadata()?;
        all.iter().find(|own| own.key == key)?.value.clone()
    };
    if said(IDENTITY).as_deref() != Some(identity) {
        return Err(wrong("it says that it belongs to another study"));
    }
    let columns = file.schema_descr().columns();
    let expected = study.parameters.len() + study.responses.len() + 2;
    if columns.len() != expected || reader.num_row_groups() != 1 {
        return Err(wrong("it has other columns"));
    }
    let rows = read_columns(&*reader.get_row_group(0)?, study)?;
    if said(CHECKSUM) != Some(checksum(&rows)) {
        return Err(wrong("its checksum does not fit its rows"));
    }
    Ok(rows)
}

fn read_columns(group: &dyn RowGroupReader, study: &StudyFile) -> Result<Vec<Row>> {
    let short = || ParquetError::General("it ends early".to_owned());
    let count = usize::try_from(group.metadata().num_rows()).map_err(|_| short())?;
    let mut cases = Vec::new();
    let ColumnReader::Int64ColumnReader(mut column) = group.get_column_reader(0)? else {
        return Err(short());
    };
    column.read_records(count, None, None, &mut cases)?;
    let [given, asked] = [study.parameters.len(), study.responses.len()];
    let values: Vec<_> = (1..=given).map(|at| numbers(group, at, count)).collect::<Result<_>>()?;
    let responses: Vec<_> = (1 + given..1 + given + asked)
        .map(|at| numbers(group, at, count))
        .collect::<Result<_>>()?;
    let codes = codes(group, 1 + given + asked, count)?;
    let all = values.iter().chain(&responses).map(Vec::len).chain([cases.len(), codes.len()]);
    if all.into_iter().any(|own| own != count) {
        return Err(short());
    }
    let row = |(at, code): (usize, Option<String>)| Row {
        case: cases[at].cast_unsigned(),
        values: values.iter().map(|own| own[at].unwrap_or(f64::NAN)).collect(),
        responses: responses.iter().map(|own| own[at]).collect(),
        code,
    };
    Ok(codes.into_iter().enumerate().map(row).collect())
}

fn numbers(group: &dyn RowGroupReader, at: usize, count: usize) -> Result<Vec<Option<f64>>> {
    let ColumnReader::DoubleColumnReader(mut column) = group.get_column_reader(at)? else {
        return Err(ParquetError::General("a column holds no numbers".to_owned()));
    };
    let (mut values, mut is_there) = (Vec::new(), Vec::new());
    column.read_records(count, Some(&mut is_there), None, &mut values)?;
    Ok(spread_out(values, &is_there))
}

fn codes(group: &dyn RowGroupReader, at: usize, count: usize) -> Result<Vec<Option<String>>> {
    let ColumnReader::ByteArrayColumnReader(mut column) = group.get_column_reader(at)? else {
        return Err(ParquetError::General("a column holds no texts".to_owned()));
    };
    let (mut values, mut is_there) = (Vec::new(), Vec::new());
    column.read_records(count, Some(&mut is_there), None, &mut values)?;
    let texts = values.iter().map(|own: &ByteArray| own.as_utf8().map(str::to_owned));
    Ok(spread_out(texts.collect::<Result<_>>()?, &is_there))
}

/// Values at the rows that have one. A column that always has one does not say where.
fn spread_out<T>(values: Vec<T>, is_there: &[i16]) -> Vec<Option<T>> {
    if is_there.is_empty() {
        return values.into_iter().map(Some).collect();
    }
    let mut values = values.into_iter();
    is_there.iter().map(|&level| if level == 1 { values.next() } else { None }).collect()
}
